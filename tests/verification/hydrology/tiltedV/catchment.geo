// The ground of blockMeshDict with the planes in triangles of about 20 m, one
// layer of prisms below. Channel and banks are quadrilaterals across, or pairs
// of triangles with 'pairs'

DefineConstant[ pairs = 0 ];

size = 20;
n = 50;

x[] = {-810, -11, -10, 10, 11, 810};
low[] = {40, 0.05, -21, -21, 0.05, 40};
high[] = {40, 0.05, -1, -1, 0.05, 40};

For i In {0:5}
    Point(1 + i) = {x[i], 0, low[i], size};
    Point(11 + i) = {x[i], 1000, high[i], size};
    Line(20 + i) = {1 + i, 11 + i};
    Transfinite Curve {20 + i} = n + 1;
EndFor
For i In {0:4}
    Line(30 + i) = {1 + i, 2 + i};
    Line(40 + i) = {11 + i, 12 + i};
    Curve Loop(i + 1) = {30 + i, 21 + i, -(40 + i), -(20 + i)};
    Surface(i + 1) = {i + 1};
EndFor
For i In {1:3}
    Transfinite Curve {30 + i, 40 + i} = 2;
    Transfinite Surface {i + 1};
    If (!pairs)
        Recombine Surface {i + 1};
    EndIf
EndFor

ground[] = {};
base[] = {};
rim[] = {};
planes[] = {};
For i In {0:4}
    layer[] = Extrude {0, 0, -10} { Surface{i + 1}; Layers{1}; Recombine; };
    ground[] += {i + 1};
    base[] += {layer[0]};
    // The sides follow the curve loop: y = 0, the right, y = 1000, the left
    If (i == 2)
        mouth[] = {layer[2]};
        channel[] = {layer[1]};
    Else
        rim[] += {layer[2]};
    EndIf
    rim[] += {layer[4]};
    If (i == 0)
        rim[] += {layer[5]};
    EndIf
    If (i == 4)
        rim[] += {layer[3]};
    EndIf
    If (i != 2)
        planes[] += {layer[1]};
    EndIf
EndFor

Physical Surface("ground") = {ground[]};
Physical Surface("base") = {base[]};
Physical Surface("mouth") = {mouth[]};
Physical Surface("rim") = {rim[]};
Physical Volume("planes") = {planes[]};
Physical Volume("channel") = {channel[]};
