#include "sim_bridge/commands/points_table.h"

#include <csv.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <istream>

#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

// Collects libcsv's callbacks. Line ends are reported one by one (CSV_REPALL_NL), which is how rows
// know their lines; empty lines are left out.
class Reader {
 public:
  explicit Reader(PointsTable& table) : table_(table) {
    if (csv_init(&parser_, CSV_STRICT | CSV_STRICT_FINI | CSV_REPALL_NL) != 0) {
      throw std::runtime_error("the CSV parser does not start");
    }
  }
  ~Reader() { csv_free(&parser_); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  void read(std::istream& in) {
    char chunk[1 << 16];
    skipByteOrderMark(in);
    while (in.read(chunk, sizeof chunk), in.gcount() > 0) {
      const auto size = static_cast<std::size_t>(in.gcount());
      if (csv_parse(&parser_, chunk, size, onCell, onRowEnd, this) != size) failParse();
    }
    if (csv_fini(&parser_, onCell, onRowEnd, this) != 0) failParse();
  }

 private:
  // Spreadsheets write one before UTF-8 text.
  static void skipByteOrderMark(std::istream& in) {
    for (const char byte : {'\xEF', '\xBB', '\xBF'}) {
      if (in.peek() != std::char_traits<char>::to_int_type(byte)) return;
      in.get();
    }
  }

  static void onCell(void* text, std::size_t size, void* self) {
    static_cast<Reader*>(self)->addCell({static_cast<const char*>(text), size});
  }
  static void onRowEnd(int terminator, void* self) {
    static_cast<Reader*>(self)->endRow(terminator);
  }

  void addCell(std::string text) {
    newlinesInCells_ += static_cast<int>(std::count(text.begin(), text.end(), '\n'));
    cells_.push_back(std::move(text));
  }

  void endRow(int terminator) {
    if (!cells_.empty()) takeRow();
    if (terminator == '\n') ++line_;
    line_ += newlinesInCells_;
    newlinesInCells_ = 0;
  }

  void takeRow() {
    const bool blank = cells_.size() == 1 && cells_.front().empty();
    if (!blank && table_.header.empty()) {
      table_.header = std::move(cells_);
    } else if (!blank) {
      if (cells_.size() != table_.header.size()) {
        throw InputError(table_.source, line_,
                         std::to_string(cells_.size()) + " cells where the header has " +
                             std::to_string(table_.header.size()));
      }
      table_.rows.push_back(std::move(cells_));
      table_.lines.push_back(line_);
    }
    cells_.clear();
  }

  [[noreturn]] void failParse() {
    throw InputError(table_.source, line_,
                     std::string("not valid CSV: ") + csv_strerror(csv_error(&parser_)));
  }

  PointsTable& table_;
  csv_parser parser_{};
  std::vector<std::string> cells_;
  int line_ = 1;
  int newlinesInCells_ = 0;
};

int columnOf(const PointsTable& table, const char* name) {
  const auto found = std::find(table.header.begin(), table.header.end(), name);
  if (found == table.header.end()) return -1;
  if (std::find(found + 1, table.header.end(), name) != table.header.end()) {
    throw InputError(table.source, 1, std::string("column '") + name + "' comes twice");
  }
  return static_cast<int>(found - table.header.begin());
}

void findColumns(PointsTable& table) {
  PointsTable::Columns& columns = table.columns;
  columns.latitude = columnOf(table, "latitude_deg");
  columns.longitude = columnOf(table, "longitude_deg");
  columns.x = columnOf(table, "x_m");
  columns.y = columnOf(table, "y_m");
  columns.height = columnOf(table, "z_m");
  columns.time = columnOf(table, "t_s");
  const bool geodetic = columns.latitude >= 0 && columns.longitude >= 0;
  const bool plane = columns.x >= 0 && columns.y >= 0;
  if (geodetic != plane) return;
  throw InputError(table.source, 1,
                   geodetic ? "the header has both latitude_deg,longitude_deg and x_m,y_m; give one"
                            : "the header needs latitude_deg,longitude_deg or x_m,y_m");
}

}  // namespace

void PointsTable::fail(std::size_t row, int column, const std::string& what) const {
  throw InputError(source, lines[row],
                   "column '" + header[static_cast<std::size_t>(column)] + "': '" +
                       rows[row][static_cast<std::size_t>(column)] + "' " + what);
}

double PointsTable::number(std::size_t row, int column) const {
  const std::string& text = rows[row][static_cast<std::size_t>(column)];
  double value = 0.0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc{} || end != text.data() + text.size()) {
    fail(row, column, "is not a number");
  }
  return value;
}

PointsTable readPoints(std::istream& in, const std::string& source) {
  PointsTable table;
  table.source = source;
  Reader(table).read(in);
  if (table.header.empty()) {
    throw InputError(source, 0,
                     "is empty; the header latitude_deg,longitude_deg or x_m,y_m is wanted");
  }
  findColumns(table);
  return table;
}

PointsTable pointsFromArguments(const std::vector<std::string>& places) {
  PointsTable table;
  table.source = "--at";
  table.header = {"latitude_deg", "longitude_deg"};
  for (const std::string& place : places) {
    const std::size_t comma = place.find(',');
    if (comma == std::string::npos || place.find(',', comma + 1) != std::string::npos) {
      throw InputError("--at: '" + place + "' is not LATITUDE,LONGITUDE");
    }
    table.rows.push_back({place.substr(0, comma), place.substr(comma + 1)});
    table.lines.push_back(0);
  }
  findColumns(table);
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    for (const int column : {table.columns.latitude, table.columns.longitude}) {
      if (!std::isfinite(table.number(row, column))) table.fail(row, column, "is not finite");
    }
  }
  return table;
}

std::string csvCell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted(2 * text.size() + 2, '\0');
  quoted.resize(csv_write(quoted.data(), quoted.size(), text.data(), text.size()));
  return quoted;
}

}  // namespace seaway::bridge
