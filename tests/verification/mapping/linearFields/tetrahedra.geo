// A slab of unstructured tetrahedra with a sloping top
SetFactory("Built-in");
h = 0.45;
Point(1) = {0, 0, 0, h};
Point(2) = {4, 0, 0, h};
Point(3) = {4, 1.2, 0, h};
Point(4) = {0, 2.6, 0, h};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Line Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
out[] = Extrude {0.3, 0.1, 2} { Surface{1}; };
Physical Surface("walls") = {1, out[0], out[2], out[3], out[4], out[5]};
Physical Volume("soil") = {out[1]};
