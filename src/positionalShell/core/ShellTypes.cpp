// SPDX-License-Identifier: GPL-3.0-or-later

#include "ShellTypes.hpp"

namespace positionalShell
{

const char* componentName(Component c)
{
    static const char* const names[dofsPerNode] =
        {"x", "y", "z", "gx", "gy", "gz", "a"};
    return names[static_cast<int>(c)];
}

} // namespace positionalShell
