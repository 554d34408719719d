// SPDX-License-Identifier: GPL-3.0-or-later
//
// What messages call the nodes and elements of a mesh: "node 5", "element 7" with
// numbers from 0, unless the source of the mesh (a file, a patch) has its own.

#ifndef positionalShell_MeshNames_hpp
#define positionalShell_MeshNames_hpp

#include <functional>
#include <string>

namespace positionalShell
{

struct MeshNames
{
    std::function<std::string(int)> node =
        [](int i) { return "node " + std::to_string(i); };

    std::function<std::string(int)> element =
        [](int i) { return "element " + std::to_string(i); };
};

} // namespace positionalShell

#endif
