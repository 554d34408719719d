/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "gmshStream.H"
#include "error.H"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

Foam::gmshStream::gmshStream(const fileName& path)
:
    path_(path)
{
    std::ifstream file(path_, std::ios::binary);
    std::ostringstream all;
    all << file.rdbuf();

    if (!file.good() || all.str().empty())
    {
        FatalErrorInFunction
            << "Cannot read the gmsh file " << path_
            << ": it is missing or empty" << nl << exit(FatalError);
    }
    content_ = all.str();
}


void Foam::gmshStream::fail(const std::string& what) const
{
    OSstream& message = FatalErrorInFunction;
    message << "gmsh file " << path_.c_str();

    if (binary_)
    {
        message << ", byte " << label(at_);
    }
    else
    {
        const auto here = content_.begin()
          + std::min(at_, content_.size());
        message
            << ", line " << label(1 + std::count(content_.begin(), here, '\n'));
    }
    if (!section_.empty())
    {
        message << ", section $" << section_.c_str();
    }
    message << ": " << what.c_str() << nl << exit(FatalError);
}


void Foam::gmshStream::skipSpace()
{
    while (at_ < content_.size() && std::isspace(content_[at_]))
    {
        ++at_;
    }
}


std::string Foam::gmshStream::textWord()
{
    skipSpace();
    std::size_t end = at_;
    while (end < content_.size() && !std::isspace(content_[end]))
    {
        ++end;
    }
    if (end == at_)
    {
        fail("the file ends here: it is truncated; save it again");
    }
    const std::string word(content_, at_, end - at_);
    at_ = end;
    return word;
}


void Foam::gmshStream::bytes(void* value, const std::size_t n)
{
    if (content_.size() - at_ < n)
    {
        fail("the file ends here: it is truncated; save it again");
    }
    std::memcpy(value, content_.data() + at_, n);
    at_ += n;
}


template<class Type>
Type Foam::gmshStream::binaryValue()
{
    Type value = 0;
    bytes(&value, sizeof(Type));
    return value;
}


Foam::label Foam::gmshStream::asLabel(const long long value) const
{
    if (value > labelMax || value < labelMin)
    {
        fail
        (
            "the number " + std::to_string(value) + " is too large; renumber"
            " the mesh (RenumberMeshNodes; RenumberMeshElements;)"
        );
    }
    return label(value);
}


std::string Foam::gmshStream::nextSection()
{
    section_.clear();
    skipSpace();
    if (at_ == content_.size())
    {
        return "";
    }

    const std::string word(textWord());
    if (word[0] != '$' || word.compare(0, 4, "$End") == 0)
    {
        fail("expected the start of a section, found '" + word + "'");
    }
    section_ = word.substr(1);
    return section_;
}


void Foam::gmshStream::endSection()
{
    skipSpace();
    const std::string expected("$End" + section_);

    if (at_ == content_.size())
    {
        fail
        (
            "the file ends without " + expected
          + ": it is truncated; save it again"
        );
    }
    if (content_.compare(at_, expected.size(), expected) != 0)
    {
        fail
        (
            "expected " + expected + ", found '" + textWord()
          + "': the section holds more than its counts say"
        );
    }
    at_ += expected.size();
}


void Foam::gmshStream::skipSection()
{
    const std::size_t end = content_.find("$End" + section_, at_);
    if (end == std::string::npos)
    {
        fail
        (
            "the file has no $End" + section_
          + ": it is truncated; save it again"
        );
    }
    at_ = end;
    endSection();
}


Foam::label Foam::gmshStream::textInteger()
{
    const std::string word(textWord());
    char* end = nullptr;
    const long long value = std::strtoll(word.c_str(), &end, 10);

    if (*end)
    {
        fail("expected a whole number, found '" + word + "'");
    }
    return asLabel(value);
}


Foam::scalar Foam::gmshStream::textNumber()
{
    const std::string word(textWord());
    char* end = nullptr;
    const double value = std::strtod(word.c_str(), &end);

    if (*end)
    {
        fail("expected a number, found '" + word + "'");
    }
    return value;
}


Foam::label Foam::gmshStream::integer()
{
    return binary_ ? asLabel(binaryValue<std::int32_t>()) : textInteger();
}


Foam::label Foam::gmshStream::size()
{
    return binary_ ? asLabel(binaryValue<std::int64_t>()) : textInteger();
}


Foam::scalar Foam::gmshStream::number()
{
    return binary_ ? binaryValue<double>() : textNumber();
}


std::string Foam::gmshStream::quoted()
{
    skipSpace();
    const std::size_t first = at_;
    const std::size_t last = content_.find('"', first + 1);

    if (content_.compare(first, 1, "\"") != 0 || last == std::string::npos)
    {
        fail("expected a name in double quotes");
    }
    at_ = last + 1;
    return content_.substr(first + 1, last - first - 1);
}


void Foam::gmshStream::endLine()
{
    while (at_ < content_.size() && content_[at_] != '\n')
    {
        if (!std::isspace(content_[at_]))
        {
            fail("expected the end of the line");
        }
        ++at_;
    }
    ++at_;
}
