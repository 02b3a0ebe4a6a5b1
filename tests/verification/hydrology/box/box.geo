// A box of length x width x height, its corner at the origin, with edges of
// about 'size': prisms in layers, or tetrahedra if there are no layers

DefineConstant[ length = 1, width = 1, height = 1, size = 0.1, layers = 0 ];

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

If (layers > 0)
    box[] = Extrude {0, 0, height} { Surface{1}; Layers{layers}; Recombine; };
Else
    box[] = Extrude {0, 0, height} { Surface{1}; };
EndIf

Physical Surface("bottom") = {1};
Physical Surface("top") = {box[0]};
Physical Surface("left") = {box[5]};
Physical Surface("right") = {box[3]};
Physical Surface("front") = {box[2]};
Physical Surface("back") = {box[4]};
Physical Volume("soil") = {box[1]};
