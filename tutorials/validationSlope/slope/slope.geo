// The validation slope: a one-layer mesh of triangular prisms, y up.
//
//   (xLeft,yCrest)___________(xCrest,yCrest)
//        |                    \             .
//        |                     \            .
//        |                   (xToe,yToe)_____(xRight,yToe)
//        |_____________________________________|   y = yBase
//
// Surfaces: ground base left right front back; volume: slope. Cells are
// sizeGround wide at the ground and grow to sizeDeep below.
//
// gmsh -setnumber sizeGround 0.5 -setnumber sizeDeep 2 slope.geo

DefineConstant[ sizeGround = 0.5, sizeDeep = 2 ];

xLeft = -46;  xCrest = -16;  xToe = 0;  xRight = 24;
yCrest = 20;  yToe = 0;  yBase = -10;
thickness = 1;

// The size holds to this distance from the ground, then grows over the next
growthStart = 2;
growthEnd = 14;

Point(1) = {xLeft, yBase, 0};
Point(2) = {xRight, yBase, 0};
Point(3) = {xRight, yToe, 0};
Point(4) = {xToe, yToe, 0};
Point(5) = {xCrest, yCrest, 0};
Point(6) = {xLeft, yCrest, 0};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 1};

Line Loop(1) = {1, 2, 3, 4, 5, 6};
Plane Surface(1) = {1};

Field[1] = Distance;
Field[1].EdgesList = {3, 4, 5};
Field[1].NNodesByEdge = 400;

Field[2] = Threshold;
Field[2].IField = 1;
Field[2].LcMin = sizeGround;
Field[2].LcMax = sizeDeep;
Field[2].DistMin = growthStart;
Field[2].DistMax = growthEnd;
Background Field = 2;

Mesh.CharacteristicLengthFromPoints = 0;
Mesh.CharacteristicLengthExtendFromBoundary = 0;

// out[0] the far face, out[1] the volume, then one face for each line
out[] = Extrude {0, 0, thickness} { Surface{1}; Layers{1}; Recombine; };

Physical Surface("back") = {1};
Physical Surface("front") = {out[0]};
Physical Surface("base") = {out[2]};
Physical Surface("right") = {out[3]};
Physical Surface("ground") = {out[4], out[5], out[6]};
Physical Surface("left") = {out[7]};
Physical Volume("slope") = {out[1]};
