// Gas around half a wall, in metres: the wall's front face is the plane x = 0,
// the ground y = 0, the symmetry plane z = 0. Allrun gives the scene's lengths
// from system/parameters and coarser; alone: gmsh explosionWall.geo

SetFactory("OpenCASCADE");

DefineConstant[
    // The scene: see system/parameters
    standOff = 3,
    height = 2,
    bulbRadius = 0.5,
    wallHeight = 4,
    wallHalfWidth = 4,
    wallThickness = 0.1,
    outerRadius = 12,

    // With more than 1: more gas, up to this many outer radii (Allrun -wide)
    reach = 1,

    // With 1: only the gas away from the wall, x < -standOff (Allrun -freeField)
    freeField = 0,

    // All sizes are multiplied with this: 2 coarse, 1 standard, 0.5 fine
    coarser = 1,

    // Edges: in the bulb, and their growth with the distance from it
    bulbSize = 0.045,
    bulbGrowth = 0.15,

    // Edges in the cone about the gauge line, which leads away from the wall:
    // proportional to the distance from the bulb's centre, but not below
    // gaugeSize; tangent of the cone's half angle, growth outside
    gaugeSize = 0.034,
    gaugeSlope = 0.0135,
    gaugeTan = 0.13,
    gaugeGrowth = 0.5,

    // Edges on the wall, and their growth with the distance from it
    wallSize = 0.17,
    wallGrowth = 0.06,

    largest = 0.42
];

// Quarter of a ball, less the wall, or an eighth of it
Sphere(1) = {-standOff, 0, 0, outerRadius};
Box(2) = {-standOff - 2*reach*outerRadius, 0, 0,
    4*reach*outerRadius, 2*reach*outerRadius, 2*reach*outerRadius};
BooleanIntersection(3) = { Volume{1}; Delete; }{ Volume{2}; };
If (freeField)
    Box(4) = {-standOff, -1, -1,
        2*outerRadius, 2*outerRadius, 2*outerRadius};
Else
    Box(4) = {0, -1, -1, wallThickness, wallHeight + 1, wallHalfWidth + 1};
EndIf
BooleanDifference(5) = { Volume{3}; }{ Volume{4}; Delete; };

gas() = {5};
If (reach > 1)
    Sphere(6) = {-standOff, 0, 0, reach*outerRadius};
    BooleanIntersection(7) = { Volume{6}; Delete; }{ Volume{2}; };
    BooleanDifference(8) = { Volume{7}; Delete; }{ Volume{3}; };
    BooleanFragments{ Volume{5}; Delete; }{ Volume{8}; Delete; }
    Physical Volume("beyond") = {8};
    gas() = {5, 8};
EndIf
Recursive Delete { Volume{2}; Volume{3}; }

e = 1e-4;
far = 4*reach*outerRadius;
symmetry() = Surface In BoundingBox {-far, -far, -e, far, far, e};
ground() = Surface In BoundingBox {-far, -e, -far, far, e, far};
wall() = Surface In BoundingBox
    {-e, -e, -e, wallThickness + e, wallHeight + e, wallHalfWidth + e};
If (freeField)
    wall() = Surface In BoundingBox
        {-standOff - e, -far, -far, -standOff + e, far, far};
EndIf
outer() = Abs(CombinedBoundary { Volume{gas()}; });
outer() -= symmetry();
outer() -= ground();
outer() -= wall();

Physical Surface("symmetry") = symmetry();
Physical Surface("ground") = ground();
Physical Surface("wall") = wall();
Physical Surface("outer") = outer();
Physical Volume("gas") = {5};

Field[1] = MathEval;
Field[1].F = Sprintf(
    "%g + %g*Max(0, Sqrt((x + %g)^2 + (y - %g)^2 + z^2) - %g)",
    coarser*bulbSize, coarser*bulbGrowth, standOff, height, bulbRadius);

Field[2] = MathEval;
Field[2].F = StrCat(
    Sprintf("%g*(Max(%g, %g*Sqrt((x + %g)^2 + (y - %g)^2 + z^2))",
        coarser, gaugeSize, gaugeSlope, standOff, height),
    Sprintf(" + %g*Max(0, Sqrt((y - %g)^2 + z^2) + %g*(x + %g)))",
        gaugeGrowth, height, gaugeTan, standOff));

Field[3] = MathEval;
Field[3].F = Sprintf(
    "%g + %g*Sqrt(Max(0, Max(-x, x - %g))^2 + Max(0, y - %g)^2 + Max(0, z - %g)^2)",
    coarser*wallSize, coarser*wallGrowth,
    wallThickness, wallHeight, wallHalfWidth);

Field[4] = MathEval;
Field[4].F = Sprintf("%g", coarser*largest);

Field[5] = Min;
Field[5].FieldsList = {1, 2, 3, 4};
Background Field = 5;

Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;

// HXT: some seconds for 300,000 tetrahedra, with good shapes
Mesh.Algorithm3D = 10;
