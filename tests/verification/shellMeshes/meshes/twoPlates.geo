// Two rectangles that share an edge; the .msh files beside this are gmsh 4.8.4's:
// gmsh -2 -order 3 twoPlates.geo -format msh22 (or msh41) -o ...
SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 2, 1};
Rectangle(2) = {2, 0, 0, 1, 1};
Coherence;
Mesh.MeshSizeMin = 1;
Mesh.MeshSizeMax = 1;
Physical Surface("left", 1) = {1};
Physical Surface("both", 5) = {1, 2};
Physical Surface(6) = {2};
Physical Curve("base") = {1};
Physical Point("tip") = {2};
