/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// Errors in dictionaries name what is wrong and what is valid

#include "dictionaryCheck.H"
#include "error.H"
#include "IStringStream.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

dictionary dictFrom(const char* text)
{
    IStringStream is(text);
    return dictionary(is);
}

template<class Action>
std::string errorOf(const Action& action)
{
    try
    {
        action();
    }
    catch (const IOerror& e)
    {
        return e.message();
    }
    return "no error";
}

} // End namespace


TEST(DictionaryCheck, acceptsKnownKeywordsAndCoeffs)
{
    const dictionary dict(dictFrom
    (
        "timeScheme twoStep; twoStepCoeffs { a 1; } otherCoeffs { b 2; }"
    ));
    EXPECT_NO_THROW(checkKeywords(dict, {"timeScheme", "shockCapturing"}));
}


TEST(DictionaryCheck, refusesUnknownKeywords)
{
    const dictionary dict(dictFrom("timeScheme twoStep;\n\ntimeScheem a;"));
    const std::string message = errorOf
    (
        [&]() { checkKeywords(dict, {"timeScheme", "shockCapturing"}); }
    );
    EXPECT_NE
    (
        message.find("Unknown keyword timeScheem (line "), std::string::npos
    ) << message;
    EXPECT_NE(message.find("timeScheme shockCapturing"), std::string::npos)
        << message;
}


// A value called Coeffs is not a dictionary of coefficients
TEST(DictionaryCheck, refusesAValueNamedLikeCoeffs)
{
    const dictionary dict(dictFrom("twoStepCoeffs 1;"));
    EXPECT_THROW(checkKeywords(dict, {"timeScheme"}), IOerror);
}


TEST(DictionaryCheck, selectsAChoice)
{
    const dictionary dict(dictFrom("scheme second;"));
    EXPECT_EQ(selectEntry(dict, "scheme", {"first", "second"}), 1);
}


TEST(DictionaryCheck, listsTheChoices)
{
    const dictionary dict(dictFrom("scheme third;"));
    const std::string message = errorOf
    (
        [&]() { selectEntry(dict, "scheme", {"first", "second"}); }
    );
    EXPECT_NE(message.find("scheme third"), std::string::npos) << message;
    EXPECT_NE(message.find("first second"), std::string::npos) << message;
}


TEST(DictionaryCheck, coeffsAreOptional)
{
    const dictionary dict(dictFrom("twoStepCoeffs { massMatrix lumped; }"));
    EXPECT_TRUE(coeffsDict(dict, "twoStep").found("massMatrix"));
    EXPECT_TRUE(coeffsDict(dict, "threeStep").empty());
}
