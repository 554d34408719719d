// SPDX-License-Identifier: GPL-3.0-or-later

#include "Orthotropic.hpp"
#include "SaintVenantKirchhoff.hpp"

#include <functional>
#include <stdexcept>

namespace positionalShell
{

namespace
{

using Parameters = Material::Parameters;

//- A material of the factory: the parameters it needs and how it is made
struct Entry
{
    std::vector<std::string> parameters;
    std::function<MaterialPtr(const Parameters&)> make;
};

MaterialPtr orthotropic(const Parameters& p)
{
    const OrthotropicConstants constants
    {
        p.at("youngsModulus1"), p.at("youngsModulus2"), p.at("youngsModulus3"),
        p.at("poissonRatio12"), p.at("poissonRatio23"), p.at("poissonRatio13"),
        p.at("shearModulus12"), p.at("shearModulus23"), p.at("shearModulus13")
    };
    return std::make_shared<Orthotropic>(constants, p.at("density"));
}

const std::map<std::string, Entry>& entries()
{
    static const std::map<std::string, Entry> all
    {
        {
            "SaintVenantKirchhoff",
            {
                {"youngsModulus", "poissonRatio", "density"},
                [](const Parameters& p)
                {
                    return std::make_shared<SaintVenantKirchhoff>
                    (
                        p.at("youngsModulus"),
                        p.at("poissonRatio"),
                        p.at("density")
                    );
                }
            }
        },
        {
            "orthotropic",
            {
                {
                    "youngsModulus1", "youngsModulus2", "youngsModulus3",
                    "poissonRatio12", "poissonRatio23", "poissonRatio13",
                    "shearModulus12", "shearModulus23", "shearModulus13",
                    "density"
                },
                orthotropic
            }
        }
    };
    return all;
}

std::string listed(const std::vector<std::string>& names)
{
    std::string list;
    for (const std::string& name : names) list += " " + name;
    return list;
}

void checkParameters
(
    const std::string& material,
    const std::vector<std::string>& needed,
    const Parameters& given
)
{
    for (const std::string& name : needed)
    {
        if (!given.count(name))
        {
            throw std::invalid_argument
            (
                "material " + material + ": parameter " + name
              + " is missing; needed:" + listed(needed)
            );
        }
    }
    if (given.size() == needed.size()) return;
    for (const auto& [name, value] : given)
    {
        bool known = false;
        for (const std::string& n : needed) known = known || n == name;
        if (!known)
        {
            throw std::invalid_argument
            (
                "material " + material + ": unknown parameter " + name
              + "; valid:" + listed(needed)
            );
        }
    }
}

} // namespace

Material::Material(double density) : density_(density)
{
    if (!(density > 0))
    {
        throw std::invalid_argument
        (
            "material: density must be positive, not " + std::to_string(density)
        );
    }
}

std::vector<std::string> Material::names()
{
    std::vector<std::string> all;
    for (const auto& [name, entry] : entries()) all.push_back(name);
    return all;
}

MaterialPtr Material::create
(
    const std::string& name,
    const Parameters& parameters
)
{
    const auto found = entries().find(name);
    if (found == entries().end())
    {
        throw std::invalid_argument
        (
            "unknown material " + name + "; valid:" + listed(names())
        );
    }
    checkParameters(name, found->second.parameters, parameters);
    return found->second.make(parameters);
}

} // namespace positionalShell
