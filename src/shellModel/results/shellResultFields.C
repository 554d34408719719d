/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "shellResultFields.H"
#include "dictionaryCheck.H"
#include "shellInput.H"
#include "shellVector.H"
#include "ListOps.H"
#include "unitConversion.H"

#include <functional>

using positionalShell::HeightResult;
using positionalShell::PointResult;

namespace Foam
{

typedef std::vector<PointResult> pointResults;

//- values(result, k): component k
static shellResultArray resultArray
(
    const word& name,
    const label nComponents,
    const pointResults& results,
    const std::function<scalar(const PointResult&, label)>& value
)
{
    shellResultArray array
    {
        name, nComponents, scalarField(nComponents*label(results.size()))
    };
    label i = 0;
    for (const PointResult& result : results)
    {
        for (label k = 0; k < nComponents; ++k)
        {
            array.values[i++] = value(result, k);
        }
    }
    return array;
}


//- The same at the three heights
static void addHeights
(
    const word& field,
    const label nComponents,
    const pointResults& results,
    const std::function<scalar(const HeightResult&, label)>& value,
    std::vector<shellResultArray>& arrays
)
{
    const wordList heights({"Lower", "Middle", "Upper"});
    forAll(heights, h)
    {
        arrays.push_back
        (
            resultArray
            (
                field + heights[h], nComponents, results,
                [&](const PointResult& r, label k)
                {
                    return value(r.height[h], k);
                }
            )
        );
    }
}


static void addSectionForces
(
    const pointResults& results,
    std::vector<shellResultArray>& arrays
)
{
    // 11 22 12 21
    static const int row[4] = {0, 1, 0, 1};
    static const int column[4] = {0, 1, 1, 0};
    typedef const PointResult& Result;

    arrays.push_back
    (
        resultArray("membraneForce", 4, results, [](Result r, label k)
        {
            return r.section.N(row[k], column[k]);
        })
    );
    arrays.push_back
    (
        resultArray("bendingMoment", 4, results, [](Result r, label k)
        {
            return r.section.M(row[k], column[k]);
        })
    );
    arrays.push_back
    (
        resultArray("shearForce", 2, results, [](Result r, label k)
        {
            return r.section.Q[k];
        })
    );
    arrays.push_back
    (
        resultArray("sectionAxis1", 3, results, [](Result r, label k)
        {
            return r.axis1[k];
        })
    );
}


typedef void addField(const pointResults&, std::vector<shellResultArray>&);

static const std::vector<std::pair<word, addField*>>& resultFields()
{
    typedef const HeightResult& Height;
    typedef const pointResults& Results;
    typedef std::vector<shellResultArray>& Arrays;

    static const std::vector<std::pair<word, addField*>> fields
    {
        {"strain", [](Results r, Arrays a)
            {
                addHeights("strain", 6, r, [](Height h, label k)
                {
                    return h.strain[k];
                }, a);
            }},
        {"secondPiola", [](Results r, Arrays a)
            {
                addHeights("secondPiola", 6, r, [](Height h, label k)
                {
                    return h.secondPiola[k];
                }, a);
            }},
        {"stress", [](Results r, Arrays a)
            {
                addHeights("stress", 6, r, [](Height h, label k)
                {
                    return h.cauchy[k];
                }, a);
            }},
        {"vonMises", [](Results r, Arrays a)
            {
                addHeights("vonMises", 1, r, [](Height h, label)
                {
                    return h.vonMises();
                }, a);
            }},
        {"sectionForces", addSectionForces}
    };
    return fields;
}


static void checkFields(const wordList& fields, const dictionary& dict)
{
    const wordList valid(shellResultFields::validFields());
    for (const word& field : fields)
    {
        if (!valid.found(field))
        {
            FatalIOErrorInFunction(dict)
                << "Unknown field " << field << nl
                << "    Valid fields are " << flatOutput(valid) << nl
                << exit(FatalIOError);
        }
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::shellResultFields::shellResultFields
(
    const dictionary& dict,
    const positionalShell::ShellModel& model
)
:
    fields_
    (
        dict.lookupOrDefault<wordList>
        (
            "fields", {"stress", "vonMises", "sectionForces"}
        )
    )
{
    checkKeywords(dict, {"fields", "axis", "foldAngle"});
    checkFields(fields_, dict);

    positionalShell::ResultOptions options;
    options.axis = toShell(dict.lookupOrDefault<vector>("axis", {1, 0, 0}));
    options.foldAngle = degToRad(dict.lookupOrDefault<scalar>("foldAngle", 20));

    rejectedIn(dict, [&]
    {
        results_.reset(new positionalShell::ShellResults(model, options));
    });
    points_.reset(new positionalShell::ResultPoints(results_->points()));
}


Foam::shellResultFields::shellResultFields
(
    const positionalShell::ShellModel& model
)
:
    points_
    (
        new positionalShell::ResultPoints
        (
            model, positionalShell::ResultOptions().foldAngle
        )
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::shellResultFields::validFields()
{
    wordList names;
    for (const auto& field : resultFields())
    {
        names.append(field.first);
    }
    return names;
}


std::vector<Foam::shellResultArray> Foam::shellResultFields::at
(
    const positionalShell::Vector& position
) const
{
    std::vector<shellResultArray> arrays;
    if (fields_.empty())
    {
        return arrays;
    }

    const pointResults results(results_->at(position));
    for (const auto& field : resultFields())
    {
        if (fields_.found(field.first))
        {
            field.second(results, arrays);
        }
    }
    return arrays;
}
