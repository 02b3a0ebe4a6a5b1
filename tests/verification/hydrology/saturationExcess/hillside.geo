// The hillside of blockMeshDict in triangular prisms: edges of about 'size'
// seen from above, in layers

DefineConstant[ size = 20, layers = 50 ];

Point(1) = {0, 0, 5.2, size};
Point(2) = {400, 0, 5, size};
Point(3) = {400, 80, 5, size};
Point(4) = {0, 80, 5.2, size};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
soil[] = Extrude {0, 0, -5} { Surface{1}; Layers{layers}; Recombine; };

Physical Surface("ground") = {1};
Physical Surface("base") = {soil[0]};
Physical Surface("outlet") = {soil[3]};
Physical Surface("upslope") = {soil[5]};
Physical Surface("frontAndBack") = {soil[2], soil[4]};
Physical Volume("hillside") = {soil[1]};
