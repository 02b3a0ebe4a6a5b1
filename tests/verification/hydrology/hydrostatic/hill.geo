// A slope of two strata, 20 m long, 8 m wide, that falls 5 m; tetrahedra, or
// with -setnumber prisms 1 prisms in layers that follow the ground

DefineConstant[ prisms = 0 ];
size = 1.6;

Point(1) = {0, 0, 5, size};
Point(2) = {20, 0, 0, size};
Point(3) = {20, 8, 0, size};
Point(4) = {0, 8, 5, size};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};

If (prisms)
    lower[] = Extrude {0, 0, 4} { Surface{1}; Layers{5}; Recombine; };
    upper[] = Extrude {0, 0, 4} { Surface{lower[0]}; Layers{5}; Recombine; };
Else
    lower[] = Extrude {0, 0, 4} { Surface{1}; };
    upper[] = Extrude {0, 0, 4} { Surface{lower[0]}; };
EndIf

Physical Surface("base") = {1};
Physical Surface("ground") = {upper[0]};
Physical Surface("sides") = {lower[{2:5}], upper[{2:5}]};
Physical Volume("clay") = {lower[1]};
Physical Volume("loam") = {upper[1]};
