/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "pvdSeries.H"
#include "OSspecific.H"
#include "error.H"

#include <fstream>
#include <iomanip>
#include <regex>
#include <sstream>

void Foam::pvdSeries::readUntil(const scalar startTime)
{
    static const std::regex dataSet
    (
        "<DataSet timestep=\"([^\"]*)\"[^>]*file=\"([^\"]*)\""
    );

    // Times are compared within the digits that name time directories
    const scalar last = startTime + 1e-9*mag(startTime);

    std::ifstream is(path_);
    for (std::string line; std::getline(is, line); )
    {
        std::smatch match;
        if (std::regex_search(line, match, dataSet))
        {
            const scalar time = std::stod(match[1]);
            if (time <= last)
            {
                files_[time] = {match[1], match[2]};
            }
        }
    }
}


Foam::pvdSeries::pvdSeries(const fileName& path, const scalar startTime)
:
    path_(path)
{
    if (isFile(path_))
    {
        readUntil(startTime);
    }
}


void Foam::pvdSeries::add(const scalar time, const fileName& file)
{
    std::ostringstream text;
    text<< std::setprecision(12) << time;
    files_[std::stod(text.str())] = {text.str(), file};

    std::ofstream os(path_);
    os  << "<?xml version=\"1.0\"?>\n"
        << "<VTKFile type=\"Collection\" version=\"0.1\">\n"
        << "  <Collection>\n";
    for (const auto& entry : files_)
    {
        os  << "    <DataSet timestep=\"" << entry.second.first
            << "\" group=\"\" part=\"0\" file=\"" << entry.second.second
            << "\"/>\n";
    }
    os  << "  </Collection>\n</VTKFile>\n";

    if (!os.good())
    {
        FatalErrorInFunction
            << "Cannot write " << path_ << exit(FatalError);
    }
}
