/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "radialProfile.H"
#include "stateScene.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

const dictionary nothing;

List<profileRow> someRows()
{
    return List<profileRow>
    ({
        {0.1, 2.0, 0, 4e5, "first"},
        {0.4, 1.0, 50, 1e5, "second"},
        {0.5, 3.0, 10, 2e5, "third"}
    });
}

std::string errorOf(const UList<profileRow>& rows, const bool round)
{
    try
    {
        radialProfile(stateScene::air(), rows, round, nothing);
    }
    catch (const Foam::error& e)
    {
        return e.message();
    }
    return "no error";
}

std::string errorOfTable(const std::string& text)
{
    testFolder folder;
    const fileName file(folder.path()/"table.csv");
    std::ofstream(file) << text;
    try
    {
        readTable(file, nothing);
    }
    catch (const Foam::error& e)
    {
        return e.message();
    }
    return "no error";
}

void expectMention(const std::string& message, const std::string& words)
{
    EXPECT_NE(message.find(words), std::string::npos) << message;
}

} // End namespace


TEST(RadialProfile, linearInConservedVariables)
{
    const radialProfile profile
    (
        stateScene::air(), someRows(), true, nothing
    );
    EXPECT_EQ(profile.start(), 0);
    EXPECT_EQ(profile.end(), 0.5);
    EXPECT_EQ(profile.at(0.05)[0], 2);
    EXPECT_NEAR(profile.at(0.25)[0], 1.5, 1e-14);
    EXPECT_NEAR(profile.at(0.25)[1], 25, 1e-12);
    const scalar energy = 0.5*(4e5/0.4 + 1e5/0.4 + 0.5*50*50);
    EXPECT_NEAR(profile.at(0.25)[2], energy, 1e-8);
    EXPECT_EQ(profile.at(0.7)[0], 3);
}


// Against sums of many points
TEST(RadialProfile, integral)
{
    const radialProfile profile
    (
        stateScene::air(), someRows(), true, nothing
    );
    for (label power = 0; power < 3; ++power)
    {
        const scalar a = 0.03;
        const scalar b = 0.47;
        const label n = 40000;
        radialProfile::State sum = radialProfile::State::Zero();
        for (label i = 0; i < n; ++i)
        {
            const scalar r = a + (i + 0.5)/n*(b - a);
            sum += (b - a)/n*std::pow(r, power)*profile.at(r);
        }
        const radialProfile::State exact = profile.integral(a, b, power);
        for (int i = 0; i < 3; ++i)
        {
            EXPECT_NEAR(sum[i]/exact[i], 1, 1e-7) << power;
        }
    }
}


TEST(RadialProfile, wrongRows)
{
    List<profileRow> rows(someRows());
    rows[1].p = -3;
    expectMention(errorOf(rows, true), "p = -3");
    expectMention(errorOf(rows, true), "second");

    rows = someRows();
    rows[2].r = 0.4;
    expectMention(errorOf(rows, true), "must grow");
    expectMention(errorOf(rows, true), "third");

    rows = someRows();
    rows[0].r = 0;
    rows[0].u = 20;
    expectMention(errorOf(rows, true), "r = 0");
    EXPECT_EQ(errorOf(rows, false), "no error");

    rows = someRows();
    rows[0].r = -0.1;
    expectMention(errorOf(rows, true), "negative");
    EXPECT_EQ(errorOf(rows, false), "no error");

    rows.setSize(1);
    expectMention(errorOf(rows, false), "1 rows");
}


TEST(RadialProfile, tables)
{
    testFolder folder;
    const fileName file(folder.path()/"table.csv");
    std::ofstream(file)
        << "# source: made up\n\np,other,r,u,rho\n"
        << "1e5, 7, 0.5, -3, 1.2\r\n2e5,8,1.5,4,2.4\n";
    List<profileRow> rows(readTable(file, nothing));
    ASSERT_EQ(rows.size(), 2);
    EXPECT_EQ(rows[0].r, 0.5);
    EXPECT_EQ(rows[0].rho, 1.2);
    EXPECT_EQ(rows[0].u, -3);
    EXPECT_EQ(rows[1].p, 2e5);
    expectMention(rows[1].where, "line 5");

    std::ofstream(file) << "0 1.2 0 1e5\n1 1.3 0 2e5\n";
    rows = readTable(file, nothing);
    ASSERT_EQ(rows.size(), 2);
    EXPECT_EQ(rows[1].rho, 1.3);
}


TEST(RadialProfile, wrongTables)
{
    expectMention(errorOfTable("r rho u\n1 2 3\n"), "no column p");
    expectMention(errorOfTable("1 2 3\n"), "line 1");
    expectMention(errorOfTable("r rho u p\n1 2 3 4\n1 2 x 4\n"), "line 3");
    expectMention(errorOfTable("r rho u p\n1 2 3 4\n1 2\n"), "columns");
}
