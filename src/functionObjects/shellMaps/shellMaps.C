/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "shellMaps.H"
#include "addToRunTimeSelectionTable.H"
#include "OSspecific.H"
#include "registeredShell.H"
#include "scalarIOField.H"
#include "shellFile.H"
#include "shellVector.H"
#include "unitConversion.H"
#include "vectorField.H"

#include <Eigen/Eigenvalues>

using positionalShell::Height;
using positionalShell::PointResult;
using positionalShell::SymmTensor;

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(shellMaps, 0);
    addToRunTimeSelectionTable(functionObject, shellMaps, dictionary);
}
}


namespace
{

const Foam::wordList fieldNames
({
    "peakDisplacement", "peakStrain", "peakVonMises"
});

const Foam::wordList units({"m", "-", "Pa"});


//- Of a tensor xx yy zz xy yz xz
double largestPrincipal(const SymmTensor& t)
{
    positionalShell::Mat3 m;
    m << t[0], t[3], t[5], t[3], t[1], t[4], t[5], t[4], t[2];
    Eigen::SelfAdjointEigenSolver<positionalShell::Mat3> solver;
    return solver.compute(m, Eigen::EigenvaluesOnly).eigenvalues()[2];
}

} // End namespace


Foam::functionObjects::shellMaps::shellMaps
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    timeFunctionObject(name, runTime)
{
    read(dict);
    start();
}


const Foam::shellModel& Foam::functionObjects::shellMaps::shell() const
{
    return registeredShell(time_, name(), typeName);
}


bool Foam::functionObjects::shellMaps::read(const dictionary& dict)
{
    return timeFunctionObject::read(dict);
}


void Foam::functionObjects::shellMaps::start()
{
    dictionary options(shell().properties().subOrEmptyDict("results"));
    options.set("fields", wordList());
    shellResultFields points(options, shell().model());

    positionalShell::ResultOptions resultOptions;
    resultOptions.foldAngle =
        degToRad(options.lookupOrDefault<scalar>("foldAngle", 20));
    results_.reset
    (
        new positionalShell::ShellResults(shell().model(), resultOptions)
    );
    continuePeaks(label(results_->points().size()));
    vtk_.reset
    (
        new shellVTK(time_, shell().model(), name(), std::move(points))
    );
    openFile();
}


void Foam::functionObjects::shellMaps::continuePeaks(const label nPoints)
{
    for (peaks& p : peaks_)
    {
        p.value = scalarField(nPoints, Zero);
        p.time = scalarField(nPoints, -1.0);
    }
    const fileName folder(fileName(time_.timeName())/"shell");
    if (!shellFileExists(time_, folder, name()))
    {
        return;
    }

    const scalarIOField all(shellFile(time_, folder, name()));
    if (all.size() != 2*nFields*nPoints)
    {
        FatalErrorInFunction
            << all.objectPath() << " holds " << all.size()
            << " values, but the shell has " << nPoints << " points, which need"
            << ' ' << 2*nFields*nPoints << nl
            << "    Restart with the mesh of the earlier run, or remove the"
            << " file to begin the peaks anew" << nl << exit(FatalError);
    }
    label i = 0;
    for (peaks& p : peaks_)
    {
        for (scalarField* field : {&p.value, &p.time})
        {
            for (scalar& value : *field)
            {
                value = all[i++];
            }
        }
    }
    Info<< type() << ' ' << name() << ": goes on with the peaks of the run"
        << " before this one" << nl << endl;
}


void Foam::functionObjects::shellMaps::openFile()
{
    if (!Pstream::master())
    {
        return;
    }
    const fileName folder
    (
        time_.globalPath()/"postProcessing"/name()/time_.timeName()
    );
    mkDir(folder);
    file_.reset(new OFstream(folder/"shellMaps.csv"));
    file_().precision(10);
    file_() << "time [s],field,unit,peak,x [m],y [m],z [m],at [s]" << endl;
}


std::array<Foam::scalarField, 3>
Foam::functionObjects::shellMaps::present() const
{
    const positionalShell::Vector& position = shell().state().position;
    const positionalShell::ResultPoints& points = results_->points();
    const vectorField displacement
    (
        nodeVectors(position, positionalShell::Component::x)
      - nodeVectors
        (
            shell().mesh().initialPositions(), positionalShell::Component::x
        )
    );
    const std::vector<PointResult> results(results_->at(position));

    std::array<scalarField, nFields> fields;
    fields.fill(scalarField(label(results.size()), Zero));
    forAll(fields[0], i)
    {
        const PointResult& r = results[i];
        fields[0][i] = mag(displacement[points.node(i)]);
        fields[1][i] = max
        (
            largestPrincipal(r.at(Height::lower).strain),
            largestPrincipal(r.at(Height::upper).strain)
        );
        for (const auto& height : r.height)
        {
            fields[2][i] = max(fields[2][i], scalar(height.vonMises()));
        }
    }
    return fields;
}


bool Foam::functionObjects::shellMaps::execute()
{
    const std::array<scalarField, nFields> now(present());
    for (label k = 0; k < nFields; ++k)
    {
        peaks& p = peaks_[k];
        forAll(p.value, i)
        {
            if (now[k][i] > p.value[i])
            {
                p.value[i] = now[k][i];
                p.time[i] = time_.value();
            }
        }
    }
    return true;
}


void Foam::functionObjects::shellMaps::writeRestart() const
{
    DynamicList<scalar> all;
    for (const peaks& p : peaks_)
    {
        all.append(p.value);
        all.append(p.time);
    }
    writeShellFile
    (
        time_,
        fileName(time_.timeName())/"shell",
        name(),
        scalarIOField::typeName,
        scalarField(all)
    );
}


void Foam::functionObjects::shellMaps::writeVTK()
{
    std::vector<shellResultArray> arrays;
    for (label k = 0; k < nFields; ++k)
    {
        arrays.push_back({fieldNames[k], 1, peaks_[k].value});
        arrays.push_back({fieldNames[k] + "Time", 1, peaks_[k].time});
    }
    vtk_->write(shell().state(), time_.timeIndex(), arrays);
}


void Foam::functionObjects::shellMaps::writeRows()
{
    if (!Pstream::master())
    {
        return;
    }
    const vectorField initial
    (
        nodeVectors
        (
            shell().mesh().initialPositions(), positionalShell::Component::x
        )
    );
    for (label k = 0; k < nFields; ++k)
    {
        const label most = findMax(peaks_[k].value);
        const vector& x = initial[results_->points().node(most)];
        file_()
            << time_.timeName() << ',' << fieldNames[k] << ',' << units[k]
            << ',' << peaks_[k].value[most] << ',' << x.x() << ',' << x.y()
            << ',' << x.z() << ',' << peaks_[k].time[most] << endl;
    }
}


bool Foam::functionObjects::shellMaps::write()
{
    writeRestart();
    writeVTK();
    writeRows();
    return true;
}
