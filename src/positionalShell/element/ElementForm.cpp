// SPDX-License-Identifier: GPL-3.0-or-later

#include "ElementForm.hpp"

#include <stdexcept>

namespace positionalShell
{

const std::vector<std::string>& elementFormNames()
{
    static const std::vector<std::string> names
    {
        "displacement", "assumedStrain"
    };
    return names;
}

const std::string& elementFormName(ElementForm form)
{
    return elementFormNames()[static_cast<int>(form)];
}

ElementForm elementForm(const std::string& name)
{
    std::string valid;
    for (std::size_t i = 0; i < elementFormNames().size(); ++i)
    {
        if (elementFormNames()[i] == name) return static_cast<ElementForm>(i);
        valid += " " + elementFormNames()[i];
    }
    throw std::invalid_argument
    (
        "unknown element form " + name + "; valid:" + valid
    );
}

} // namespace positionalShell
