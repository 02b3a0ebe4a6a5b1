// The catchment in plan, extruded downwards in flat layers of height 1 for
// terrainMesh to move: x down the valley from the divide, y across, z up.
//
// Surfaces: ground base upstream outlet left right; volume: catchment.
//
// The road (x 500..512), the embankment's face and the valley's axis lie on
// mesh lines. sizeScale coarsens everything.

DefineConstant[ sizeScale = 1, nLayers = 14 ];

xEnd = 560;  yEdge = 150;
xSection = 440;  xRoad = 500;  xShoulder = 512;

sizeFar = 30*sizeScale;         // hillsides
sizeChannel = 12*sizeScale;     // along the axis, where the runoff gathers
sizeSection = 5*sizeScale;    // road, embankment and what lies upstream

Point(1) = {0, -yEdge, 0};
Point(2) = {xEnd, -yEdge, 0};
Point(3) = {xEnd, 0, 0};
Point(4) = {xEnd, yEdge, 0};
Point(5) = {0, yEdge, 0};
Point(6) = {0, 0, 0};
Point(7) = {xSection, 0, 0};
Point(8) = {xRoad, 0, 0};
Point(9) = {xShoulder, 0, 0};

// The upper ends of the embankment's edges, inside the plan
yFill = 60;
Point(10) = {xRoad, -yFill, 0};
Point(11) = {xRoad, yFill, 0};
Point(12) = {xShoulder, -yFill, 0};
Point(13) = {xShoulder, yFill, 0};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 1};
Line(7) = {6, 7};
Line(8) = {7, 8};
Line(9) = {8, 9};
Line(10) = {9, 3};
Line(11) = {10, 8};
Line(12) = {8, 11};
Line(13) = {12, 9};
Line(14) = {9, 13};

Line Loop(1) = {1, 2, -10, -9, -8, -7, 6};
Line Loop(2) = {7, 8, 9, 10, 3, 4, 5};
Plane Surface(1) = {1};
Plane Surface(2) = {2};
Line{11, 13} In Surface{1};
Line{12, 14} In Surface{2};

Field[1] = Distance;
Field[1].EdgesList = {7, 8, 9, 10};
Field[1].NNodesByEdge = 200;

Field[2] = Threshold;
Field[2].IField = 1;
Field[2].LcMin = sizeChannel;
Field[2].LcMax = sizeFar;
Field[2].DistMin = 15;
Field[2].DistMax = 90;

Field[3] = Distance;
Field[3].EdgesList = {9, 10, 11, 12, 13, 14};
Field[3].NNodesByEdge = 100;

Field[4] = Threshold;
Field[4].IField = 3;
Field[4].LcMin = sizeSection;
Field[4].LcMax = sizeFar;
Field[4].DistMin = 12;
Field[4].DistMax = 100;

Field[5] = Min;
Field[5].FieldsList = {2, 4};
Background Field = 5;

Mesh.CharacteristicLengthFromPoints = 0;
Mesh.CharacteristicLengthExtendFromBoundary = 0;

south[] = Extrude {0, 0, -nLayers} { Surface{1}; Layers{nLayers}; Recombine; };
north[] = Extrude {0, 0, -nLayers} { Surface{2}; Layers{nLayers}; Recombine; };

// out[0] the far face, out[1] the volume, then a face for each line of the loop
Physical Surface("ground") = {1, 2};
Physical Surface("base") = {south[0], north[0]};
Physical Surface("right") = {south[2]};
Physical Surface("left") = {north[7]};
Physical Surface("outlet") = {south[3], north[6]};
Physical Surface("upstream") = {south[8], north[8]};
Physical Volume("catchment") = {south[1], north[1]};
