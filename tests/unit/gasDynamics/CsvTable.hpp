/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#pragma once

#include <cstddef>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

//! A table of the tests' reference data: comments with #, a line of column
//  names, then one row per line. Columns are found by name.
class CsvTable
{
    std::map<std::string, std::size_t> column_;
    std::vector<std::vector<std::string>> rows_;

    static std::vector<std::string> split(const std::string& line)
    {
        std::vector<std::string> cells;
        std::stringstream stream(line);
        for (std::string cell; std::getline(stream, cell, ','); )
        {
            cells.push_back(cell);
        }
        return cells;
    }

public:

    explicit CsvTable(const std::string& path)
    {
        std::ifstream file(path);
        if (!file)
        {
            throw std::runtime_error("cannot open " + path);
        }
        for (std::string line; std::getline(file, line); )
        {
            if (line.empty() || line[0] == '#')
            {
                continue;
            }
            const std::vector<std::string> cells = split(line);
            if (column_.empty())
            {
                for (std::size_t i = 0; i < cells.size(); ++i)
                {
                    column_[cells[i]] = i;
                }
                continue;
            }
            rows_.push_back(cells);
        }
    }

    std::size_t size() const { return rows_.size(); }

    const std::string& text(std::size_t row, const std::string& name) const
    {
        return rows_.at(row).at(column_.at(name));
    }

    double operator()(std::size_t row, const std::string& name) const
    {
        return std::stod(text(row, name));
    }
};
