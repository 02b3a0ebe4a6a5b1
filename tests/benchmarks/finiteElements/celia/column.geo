DefineConstant[ size = 0.025, width = 0.1 ];
Point(1) = {0,0,0,size}; Point(2)={width,0,0,size}; Point(3)={width,1,0,size}; Point(4)={0,1,0,size};
Line(1)={1,2}; Line(2)={2,3}; Line(3)={3,4}; Line(4)={4,1};
Line Loop(1)={1,2,3,4}; Plane Surface(1)={1};
out[] = Extrude {0,0,0.1} { Surface{1}; Layers{1}; Recombine; };
Physical Surface("back")={1}; Physical Surface("front")={out[0]};
Physical Surface("bottom")={out[2]}; Physical Surface("right")={out[3]}; Physical Surface("top")={out[4]}; Physical Surface("left")={out[5]};
Physical Volume("soil")={out[1]};
