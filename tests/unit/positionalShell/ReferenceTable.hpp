// SPDX-License-Identifier: GPL-3.0-or-later
//
// A csv file of the data folder: comment lines '#', one line of names, rows.

#ifndef ReferenceTable_hpp
#define ReferenceTable_hpp

#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace shellTest
{

class ReferenceRow
{
public:

    std::map<std::string, std::string> cells;

    const std::string& text(const std::string& name) const { return cells.at(name); }
    double number(const std::string& name) const { return std::stod(cells.at(name)); }
};

inline std::vector<std::string> splitCells(const std::string& line)
{
    std::istringstream in(line);
    std::vector<std::string> cells;
    std::string cell;
    while (std::getline(in, cell, ',')) cells.push_back(cell);
    return cells;
}

//- Rows by column name. The tests run in their own folder.
inline std::vector<ReferenceRow> referenceTable(const std::string& file)
{
    std::ifstream in("data/" + file);
    if (!in) throw std::runtime_error("cannot read data/" + file);
    std::vector<std::string> names;
    std::vector<ReferenceRow> rows;
    std::string line;
    while (std::getline(in, line))
    {
        if (line.empty() || line[0] == '#') continue;
        const std::vector<std::string> cells = splitCells(line);
        if (names.empty())
        {
            names = cells;
            continue;
        }
        ReferenceRow row;
        for (std::size_t i = 0; i < names.size(); ++i) row.cells[names[i]] = cells[i];
        rows.push_back(row);
    }
    return rows;
}

} // namespace shellTest

#endif
