#include "sim_bridge/commands/points_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

PointsTable read(const std::string& text) {
  std::istringstream in(text);
  return readPoints(in, "p.csv");
}

std::string faultOf(const std::string& text) {
  return test::inputErrorOf([&] {
    const PointsTable table = read(text);
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      table.number(row, table.columns.x);
    }
  });
}

TEST(PointsTable, FindsColumnsInAnyOrderAndPassesOthersThrough) {
  const PointsTable table = read("id,y_m,t_s,x_m\n\"a,b\",1,2,3\n");
  EXPECT_EQ(table.number(0, table.columns.x), 3.0);
  EXPECT_EQ(table.number(0, table.columns.y), 1.0);
  EXPECT_EQ(table.number(0, table.columns.time), 2.0);
  EXPECT_EQ(table.columns.height, -1);
  EXPECT_EQ(table.rows[0][0], "a,b");
}

TEST(PointsTable, EmptyLinesLineEndsAndAMissingLastOneDoNotMatter) {
  const PointsTable table = read("x_m,y_m\r\n1,2\r\n\r\n3,4");
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(table.lines[0], 2);
  EXPECT_EQ(table.lines[1], 4);
  EXPECT_EQ(table.number(1, table.columns.y), 4.0);
}

TEST(PointsTable, AByteOrderMarkIsNoPartOfTheHeader) {
  const PointsTable table = read("\xEF\xBB\xBFx_m,y_m\n1,2\n");
  EXPECT_EQ(table.header[0], "x_m");
  EXPECT_EQ(table.number(0, table.columns.y), 2.0);
  EXPECT_NE(faultOf("\xEF\xBB\xBF").find("is empty"), std::string::npos);
}

TEST(PointsTable, BadCellsAreNamedByFileLineAndColumn) {
  EXPECT_EQ(faultOf("x_m,y_m\n1,2\nabc,3\n"), "p.csv:3: column 'x_m': 'abc' is not a number");
  EXPECT_EQ(faultOf("x_m,y_m\n,2\n"), "p.csv:2: column 'x_m': '' is not a number");
  EXPECT_EQ(faultOf("x_m,y_m\n1,2,3\n"), "p.csv:2: 3 cells where the header has 2");
}

TEST(PointsTable, WantsExactlyOnePairOfCoordinates) {
  EXPECT_NE(faultOf("x_m,z_m\n1,2\n").find("needs latitude_deg,longitude_deg or x_m,y_m"),
            std::string::npos);
  EXPECT_NE(faultOf("x_m,y_m,latitude_deg,longitude_deg\n").find("both"), std::string::npos);
  EXPECT_NE(faultOf("x_m,y_m,x_m\n").find("comes twice"), std::string::npos);
  EXPECT_NE(faultOf("").find("is empty"), std::string::npos);
}

TEST(PointsTable, NumbersThatAreNotFinitePassToTheSurface) {
  const PointsTable table = read("x_m,y_m\nnan,inf\n");
  EXPECT_TRUE(std::isnan(table.number(0, table.columns.x)));
  EXPECT_TRUE(std::isinf(table.number(0, table.columns.y)));
}

TEST(PointsTable, ArgumentsAreLatitudeCommaLongitude) {
  const PointsTable table = pointsFromArguments({"-28.5,78"});
  EXPECT_EQ(table.number(0, table.columns.latitude), -28.5);
  for (const char* bad : {"28.5", "1,2,3", "a,b", "nan,0", "1,inf", ""}) {
    EXPECT_NE(test::inputErrorOf([&] { pointsFromArguments({bad}); }), "") << bad;
  }
}

TEST(PointsTable, CellsAreQuotedWhereTheyMustBe) {
  EXPECT_EQ(csvCell("plain"), "plain");
  EXPECT_EQ(csvCell("a,b"), "\"a,b\"");
  EXPECT_EQ(csvCell("say \"hi\""), "\"say \"\"hi\"\"\"");
}

TEST(PointsTableHard, QuotedLineEndsCountAsLines) {
  EXPECT_EQ(faultOf("id,x_m,y_m\n\"two\nlines\",1,2\nx,bad,2\n"),
            "p.csv:4: column 'x_m': 'bad' is not a number");
}

TEST(PointsTableHard, AnUnclosedQuoteIsAnError) {
  EXPECT_NE(faultOf("x_m,y_m\n\"1,2\n").find("not valid CSV"), std::string::npos);
}

}  // namespace
}  // namespace seaway::bridge
