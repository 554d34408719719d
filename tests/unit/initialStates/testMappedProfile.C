/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// Profiles over r put into scenes: (I5), (I6)

#include "mappedProfile.H"
#include "stateScene.H"

#include <gtest/gtest.h>
#include <iomanip>

using namespace Foam;

namespace
{

//- A smooth wave about r = 0.5, of width 0.2, in air at rest
scalar wave(const scalar r)
{
    return mag(r - 0.5) < 0.2 ? sqr(std::cos(2.5*M_PI*(r - 0.5))) : 0;
}

struct flow
{
    scalar rho, u, p;
};

flow waveAt(const scalar r)
{
    const scalar rho0 = stateScene::p0/(287*stateScene::T0);
    return flow
    {
        rho0*(1 + wave(r)),
        100*wave(r),
        stateScene::p0*(1 + 2*wave(r))
    };
}

//- The wave as a table of rows 1/400 apart
fileName writeWave(const stateScene& scene)
{
    const fileName file(scene.folder().path()/"wave.csv");
    std::ofstream os(file);
    os << std::setprecision(17) << "r,rho,u,p\n";
    for (label i = 0; i <= 400; ++i)
    {
        const scalar r = i/400.0;
        const flow f = waveAt(r);
        os << r << "," << f.rho << "," << f.u << "," << f.p << "\n";
    }
    return file;
}

std::string entries(const stateScene& scene, const std::string& more)
{
    return "file \"" + writeWave(scene) + "\"; " + more;
}

//- The wave's excess of mass and energy over still air, in one direction r^c,
//  by many points
gasNodes::State excess(const label c)
{
    gasNodes::State sum = gasNodes::State::Zero();
    const label n = 100000;
    for (label i = 0; i < n; ++i)
    {
        const scalar r = 0.3 + 0.4*(i + 0.5)/n;
        const flow f = waveAt(r);
        sum +=
            0.4/n*std::pow(r, c)
           *(
                conservedState
                (
                    stateScene::air(), f.p, vector(f.u, 0, 0), f.p/(287*f.rho)
                )
              - stateScene::still()
            );
    }
    return sum;
}

//- Scene and profile of a geometry, and the factor of its integral
struct geometry
{
    const char* name;
    const char* words;
    label dim;
    label power;
    scalar around;
    bool atCentre;
};

const geometry geometries[] =
{
    {"sphere", "geometry spherical; centre (0 0 0);", 3, 2, M_PI/2, true},
    {"cylinder", "geometry cylindrical; centre (0 0 0);", 2, 1, 0.05*M_PI,
        true},
    {"cylinderInSpace",
        "geometry cylindrical; centre (0 0 0); axis (0 0 1);", 3, 1, M_PI/2,
        true},
    {"line", "geometry planar; centre (0 0 0); axis (1 0 0);", 1, 0, 0.01,
        false},
    {"plane", "geometry planar; centre (0 0 0); axis (1 0 0);", 2, 0, 0.1,
        false},
    {"space", "geometry planar; centre (0 0 0); axis (0 1 0);", 3, 0, 1, false}
};

class Profiles : public testing::TestWithParam<geometry>
{
protected:

    boxMesh mesh() const
    {
        const label dim = GetParam().dim;
        return randomMesh(dim, dim == 3 ? 14 : 40);
    }

    //- r and its direction, without convexBody
    scalar r(const point& x, vector& e) const
    {
        vector d(x);
        const std::string name(GetParam().name);
        if (name.substr(0, 6) != "sphere")
        {
            d.z() = 0;
        }
        if (name == "line" || name == "plane")
        {
            d = vector(x.x(), 0, 0);
        }
        if (name == "space")
        {
            d = vector(0, x.y(), 0);
        }
        e = d/max(mag(d), VSMALL);
        return mag(d);
    }
};

} // End namespace


// The exact integral of the table is that of the wave to the square of the
// rows' distance
TEST_P(Profiles, totals)
{
    stateScene scene(mesh());
    const gasNodes::State before = scene.nodes().total();
    scene.set("mappedProfile", entries(scene, GetParam().words));
    const gasNodes::State gain = scene.nodes().total() - before;
    const gasNodes::State wave = GetParam().around*excess(GetParam().power);
    EXPECT_NEAR(gain[0]/wave[0], 1, 2e-4);
    EXPECT_NEAR(gain[4]/wave[4], 1, 2e-4);
}


// To round-off, against the profile's own integral
TEST_P(Profiles, totalsExactly)
{
    stateScene scene(mesh());
    const gasNodes::State before = scene.nodes().total();
    scene.set("mappedProfile", entries(scene, GetParam().words));
    const gasNodes::State gain = scene.nodes().total() - before;

    const radialProfile profile
    (
        stateScene::air(), readTable(writeWave(scene), dictionary()),
        GetParam().atCentre, dictionary()
    );
    const scalar r = GetParam().power + 1.0;
    const radialProfile::State content =
        GetParam().around*profile.integral(0, 1, GetParam().power);
    const gasNodes::State air = GetParam().around/r*stateScene::still();
    EXPECT_NEAR(gain[0]/(content[0] - air[0]), 1, 1e-10);
    EXPECT_NEAR(gain[4]/(content[2] - air[4]), 1, 1e-10);
}


// Nodes have the profile's values but for the correction, and still air stays
// as it is bit for bit
TEST_P(Profiles, values)
{
    stateScene scene(mesh());
    scene.set("mappedProfile", entries(scene, GetParam().words));
    const gasNodes& nodes = scene.nodes();
    label inWave = 0;
    for (label i = 0; i < nodes.size(); ++i)
    {
        vector e;
        const scalar s = r(nodes.x(i), e);
        const flow f = waveAt(s);
        const scalar rho = nodes.p()[i]/(287*nodes.T()[i]);
        if (wave(s) > 0.02)
        {
            ++inWave;
            EXPECT_NEAR(nodes.p()[i]/f.p, 1, 0.06);
            EXPECT_NEAR(rho/f.rho, 1, 0.03);
            EXPECT_NEAR(mag(nodes.U()[i] - f.u*e), 0, 0.05);
        }
        else if (mag(s - 0.5) > 0.21)
        {
            EXPECT_NEAR(nodes.p()[i]/stateScene::p0, 1, 1e-12);
            EXPECT_EQ(mag(nodes.U()[i]), 0);
        }
    }
    EXPECT_GT(inWave, 8);
}


// Half of the table: nothing beyond
TEST(MappedProfile, radius)
{
    stateScene scene(boxMesh::plane(30, 30));
    scene.set
    (
        "mappedProfile",
        entries
        (
            scene, "geometry cylindrical; centre (0.5 0.5 0); radius 0.45;"
        )
    );
    const gasNodes& nodes = scene.nodes();
    for (label i = 0; i < nodes.size(); ++i)
    {
        vector d(nodes.x(i) - point(0.5, 0.5, 0));
        d.z() = 0;
        if (mag(d) > 0.45 + 0.05)
        {
            EXPECT_EQ(nodes.p()[i], stateScene::p0);
        }
    }
    EXPECT_GT(max(nodes.p()), 2e5);
}


TEST(MappedProfile, planarPartOfTheMesh)
{
    stateScene scene(boxMesh::lines(100));
    const gasNodes::State before = scene.nodes().total();
    scene.set
    (
        "mappedProfile",
        entries(scene, "geometry planar; centre (-0.5 0 0); axis (2 0 0);")
    );
    // The right half of the wave is in the mesh
    const gasNodes::State gain = scene.nodes().total() - before;
    EXPECT_NEAR(gain[0]/(0.005*excess(0)[0]), 1, 2e-4);
    EXPECT_GT(scene.nodes().p()[0], 2.9e5);
}


// Near-vacuum within a shell whose nodes hold too much of it: density and
// energy are taken from the shell, so that nothing becomes negative
TEST(MappedProfile, nearVacuum)
{
    stateScene scene(boxMesh::lines(100));
    const fileName file(scene.folder().path()/"blast.csv");
    std::ofstream(file)
        << "r,rho,u,p\n0,1e-4,0,10\n0.397,1e-4,300,10\n0.398,6,300,8e5\n"
        << "0.602,6,300,8e5\n0.603,1.2014,0,1e5\n1,1.2014,0,1e5\n";
    scene.set
    (
        "mappedProfile",
        "file \"" + file + "\"; geometry planar; centre (0 0 0); "
        "axis (1 0 0);"
    );
    const radialProfile profile
    (
        stateScene::air(), readTable(file, dictionary()), false, dictionary()
    );
    const radialProfile::State content = 0.01*profile.integral(0, 1, 0);
    const gasNodes::State after = scene.nodes().total();
    EXPECT_NEAR(after[0]/content[0], 1, 1e-12);
    EXPECT_NEAR(after[4]/content[2], 1, 1e-12);
    EXPECT_GT(min(scene.nodes().p()), 5);
}


// A wave that falls between the nodes
TEST(MappedProfile, meshTooCoarse)
{
    stateScene scene(boxMesh::space(2, 2, 2));
    const std::string message = scene.errorOf
    (
        "mappedProfile",
        entries(scene, "geometry spherical; centre (0 0 0); radius 0.9;")
    );
    EXPECT_NE(message.find("too coarse"), std::string::npos) << message;
    EXPECT_NE(message.find("refine"), std::string::npos) << message;
}


INSTANTIATE_TEST_SUITE_P
(
    Geometries, Profiles, testing::ValuesIn(geometries),
    [](const auto& info) { return std::string(info.param.name); }
);
