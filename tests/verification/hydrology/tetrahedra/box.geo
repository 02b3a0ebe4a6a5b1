// A box of length x width x height, tetrahedra of about 'size'

DefineConstant[ length = 10, width = 4, height = 4, size = 1 ];

Point(1) = {0, 0, 0, size};
Point(2) = {length, 0, 0, size};
Point(3) = {length, width, 0, size};
Point(4) = {0, width, 0, size};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
box[] = Extrude {0, 0, height} { Surface{1}; };

Physical Surface("bottom") = {1};
Physical Surface("top") = {box[0]};
Physical Surface("left") = {box[5]};
Physical Surface("right") = {box[3]};
Physical Surface("sides") = {box[2], box[4]};
Physical Volume("soil") = {box[1]};
