// A slope of three layers, 12 m long, 6 m wide, that falls 3 m; tetrahedra, or
// with -setnumber prisms 1 prisms in layers that follow the ground

DefineConstant[ prisms = 0 ];
size = 3;

Point(1) = {0, 0, 3, size};
Point(2) = {12, 0, 0, size};
Point(3) = {12, 6, 0, size};
Point(4) = {0, 6, 3, size};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};

If (prisms)
    lower[] = Extrude {0, 0, 1} { Surface{1}; Layers{2}; Recombine; };
    middle[] = Extrude {0, 0, 1} { Surface{lower[0]}; Layers{2}; Recombine; };
    upper[] = Extrude {0, 0, 1} { Surface{middle[0]}; Layers{3}; Recombine; };
Else
    lower[] = Extrude {0, 0, 1} { Surface{1}; };
    middle[] = Extrude {0, 0, 1} { Surface{lower[0]}; };
    upper[] = Extrude {0, 0, 1} { Surface{middle[0]}; };
EndIf

Physical Surface("base") = {1};
Physical Surface("ground") = {upper[0]};
Physical Surface("right") = {lower[3], middle[3], upper[3]};
Physical Surface("left") =
{
    lower[{2, 4, 5}], middle[{2, 4, 5}], upper[{2, 4, 5}]
};
Physical Volume("lower") = {lower[1]};
Physical Volume("middle") = {middle[1]};
Physical Volume("upper") = {upper[1]};
