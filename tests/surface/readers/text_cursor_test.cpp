#include "surface/spectra/readers/text_cursor.h"

#include <gtest/gtest.h>

#include <clocale>

#include "surface/input_error.h"

namespace seaway {
namespace {

TEST(TextCursor, ReadsNumbersAsCAndFortranWriteThem) {
  EXPECT_EQ(numberOf("1.5"), 1.5);
  EXPECT_EQ(numberOf(".0325"), 0.0325);
  EXPECT_EQ(numberOf("-99."), -99.0);
  EXPECT_EQ(numberOf("+1.5E+02"), 150.0);
  EXPECT_EQ(numberOf("1.5D-03"), 1.5e-3);
  EXPECT_EQ(numberOf("0.123-100"), 0.123e-100);
  EXPECT_EQ(numberOf("0.123+100"), 0.123e100);
}

TEST(TextCursor, TakesNothingElseForANumber) {
  for (const char* word : {"", "-", "+", "++1", "nan", "NaN", "inf", "1e999", "0x10", "1,5", "1.5 ",
                           "1.5e", "12-100", "a.b-100", "********", "1.2.3", "1D", "1e-", "e5"}) {
    EXPECT_FALSE(numberOf(word)) << "'" << word << "'";
  }
}

TEST(TextCursor, NumbersDoNotFollowTheLocale) {
  const std::string before = std::setlocale(LC_NUMERIC, nullptr);
  std::setlocale(LC_NUMERIC, "de_DE.UTF-8");  // where it is not installed the test is a weak one
  EXPECT_EQ(numberOf("1.5"), 1.5);
  EXPECT_FALSE(numberOf("1,5"));
  std::setlocale(LC_NUMERIC, before.c_str());
}

TEST(TextCursor, WordsStandBetweenBlanksAndSeparators) {
  EXPECT_EQ(splitWords(" a  b\tc\r"), (std::vector<std::string_view>{"a", "b", "c"}));
  EXPECT_EQ(splitWords("1,2, 3", ","), (std::vector<std::string_view>{"1", "2", "3"}));
  EXPECT_TRUE(splitWords(" \t").empty());
}

TEST(TextCursor, WalksAcrossLinesAndCountsThem) {
  const TextFile file{"f", "1 2\r\n\n 3 text\n4"};
  TextCursor cursor(file);
  EXPECT_EQ(cursor.takeNumber("a"), 1.0);
  EXPECT_EQ(cursor.takeNumber("a"), 2.0);
  EXPECT_EQ(cursor.lineNumber(), 1);
  EXPECT_EQ(cursor.takeNumber("a"), 3.0);
  EXPECT_EQ(cursor.lineNumber(), 3);
  EXPECT_THROW(cursor.requireLineEnd("3"), InputError);
  EXPECT_TRUE(cursor.nextLine());
  EXPECT_TRUE(cursor.isUnended());
  EXPECT_FALSE(cursor.atEnd());
  EXPECT_EQ(cursor.takeNumber("a"), 4.0);
  EXPECT_TRUE(cursor.atEnd());
  EXPECT_FALSE(cursor.nextLine());
}

TEST(TextCursor, FailuresNameFileLineValueAndWhatWasWanted) {
  const TextFile file{"buoy.txt", "1\nzwei\n3"};
  const auto messageOf = [&](auto use) {
    TextCursor cursor(file);
    cursor.nextLine();
    try {
      use(cursor);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  EXPECT_EQ(messageOf([](TextCursor& c) {
              c.takeWord("a");
              c.takeNumber("depth");
            }),
            "buoy.txt:2: depth: 'zwei' is not a number");
  EXPECT_EQ(messageOf([](TextCursor& c) {
              for (int i = 0; i < 4; ++i) c.takeWord("the fourth");
            }),
            "buoy.txt:3: ends before the fourth");
  EXPECT_EQ(messageOf([](TextCursor& c) { c.wholeNumber("1.5", "count", 1, 9); }),
            "buoy.txt:1: count: '1.5' is not allowed; must be a whole number in [1, 9]");
}

}  // namespace
}  // namespace seaway
