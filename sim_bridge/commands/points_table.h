#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace seaway::bridge {

/// Points as they came in, with what every cell says and where it stands.
struct PointsTable {
  /// Column indices; −1 where there is none. Either the geodetic or the sea-plane pair is there.
  struct Columns {
    int latitude = -1, longitude = -1;  ///< degrees
    int x = -1, y = -1;                 ///< sea plane, m
    int height = -1;                    ///< z_m
    int time = -1;                      ///< t_s
  };

  std::string source;  ///< file name for messages
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
  std::vector<int> lines;  ///< of each row, from 1
  Columns columns;

  /// Number in a cell; NaN and infinities pass. Throws InputError: file, line, column, text.
  double number(std::size_t row, int column) const;

  [[noreturn]] void fail(std::size_t row, int column, const std::string& what) const;
};

/// Reads CSV with a header. Columns `latitude_deg,longitude_deg` or `x_m,y_m` are wanted, `z_m` and
/// `t_s` known; others pass through. Throws InputError, with file and line, for anything malformed.
PointsTable readPoints(std::istream& in, const std::string& source);

/// Points given on the command line as `LATITUDE,LONGITUDE`. Throws InputError.
PointsTable pointsFromArguments(const std::vector<std::string>& places);

/// A cell as CSV wants it: quoted where it must be.
std::string csvCell(const std::string& text);

}  // namespace seaway::bridge
