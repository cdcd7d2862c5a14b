#include "sim_bridge/report/plot.h"

#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <stdexcept>

namespace seaway::bridge {
namespace {

constexpr std::array colours{"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"};

/// A text in a gnuplot script.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\n' || c == '\r') continue;
    result += c;
    if (c == '\'') result += c;
  }
  return result + "'";
}

/// A script's file, gone with the object.
class ScriptFile {
 public:
  explicit ScriptFile(const std::string& script)
      : path_((std::filesystem::temp_directory_path() / "seaway_plot_XXXXXX").string()) {
    const int descriptor = mkstemp(path_.data());
    if (descriptor < 0) throw std::runtime_error("plots: no temporary file at " + path_);
    close(descriptor);
    std::ofstream(path_) << script;
  }
  ~ScriptFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  ScriptFile(const ScriptFile&) = delete;
  ScriptFile& operator=(const ScriptFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

std::string gnuplot(const std::string& script) {
  const ScriptFile file(script);
  std::FILE* pipe = popen(("gnuplot '" + file.path() + "' 2>&1").c_str(), "r");
  if (!pipe) throw std::runtime_error("plots: gnuplot cannot be started");
  std::string output;
  std::array<char, 4096> buffer{};
  while (const std::size_t read = std::fread(buffer.data(), 1, buffer.size(), pipe)) {
    output.append(buffer.data(), read);
  }
  const int status = pclose(pipe);
  const std::size_t start = output.find("<svg");
  if (status != 0 || start == std::string::npos) {
    throw std::runtime_error("plots: gnuplot (Debian package gnuplot-nox) failed: " + output);
  }
  return output.substr(start);
}

std::string preamble(const std::string& title, int width, int height) {
  return fmt::format(
      "set terminal svg size {},{} fixed font 'sans-serif,13' noenhanced background '#ffffff'\n"
      "set title {}\nset border 3 lc rgb '#666666'\nset tics nomirror\n"
      "set grid lc rgb '#dddddd' lt 1\nset key top right\nset style fill solid 0.55 noborder\n",
      width, height, quoted(title));
}

std::string axis(const char* name, const Axis& axis) {
  const auto end = [](const std::optional<double>& value) {
    return value ? fmt::format("{}", *value) : std::string("*");
  };
  std::string script = fmt::format("set {}label {}\nset {}range [{}:{}]\n", name,
                                   quoted(axis.label), name, end(axis.low), end(axis.high));
  if (axis.logarithmic) script += fmt::format("set logscale {}\nset format {} '%g'\n", name, name);
  return script;
}

std::string dataBlock(std::size_t index, const Curve& curve) {
  std::string text = fmt::format("$data{} << EOD\n", index);
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    if (!std::isfinite(curve.x[i]) || !std::isfinite(curve.y[i])) {
      text += "\n";
      continue;
    }
    text += fmt::format("{} {}", curve.x[i], curve.y[i]);
    text += curve.width.empty() ? "\n" : fmt::format(" {}\n", curve.width[i]);
  }
  return text + "EOD\n";
}

std::string styleOf(const Curve& curve, const char* colour) {
  switch (curve.style) {
    case CurveStyle::line:
      return fmt::format("with lines lw 2 lc rgb '{}'", colour);
    case CurveStyle::dashed:
      return fmt::format("with lines lw 2 dt 2 lc rgb '{}'", colour);
    case CurveStyle::points:
      return fmt::format("with points pt 7 ps 0.45 lc rgb '{}'", colour);
    case CurveStyle::mark:
      return fmt::format("with points pt 6 ps 1.3 lw 3 lc rgb '{}'", colour);
    case CurveStyle::boxes:
      return fmt::format("with boxes lc rgb '{}'", colour);
  }
  return "";
}

bool isEmpty(const Curve& curve) {
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    if (std::isfinite(curve.x[i]) && std::isfinite(curve.y[i])) return false;
  }
  return true;
}

std::string palette() {
  return "set palette defined (0 '#440154', 0.25 '#3b528b', 0.5 '#21918c', 0.75 '#5ec962', "
         "1 '#fde725')\n";
}

}  // namespace

std::string svgOf(const Plot& plot) {
  Axis x = plot.x, y = plot.y;
  // Gnuplot refuses axes that it finds no range for.
  if (std::all_of(plot.curves.begin(), plot.curves.end(), isEmpty)) {
    for (Axis* axis : {&x, &y}) {
      if (!axis->low) axis->low = 0.1;
      if (!axis->high) axis->high = 10.0 * std::max(0.1, std::abs(*axis->low));
    }
  }
  std::string script = preamble(plot.title, 820, 400) + axis("x", x) + axis("y", y);
  // Long lists of names would lie over the curves.
  if (plot.curves.size() > 3) script += "set key outside right top\n";
  std::string draw = "plot ";
  for (std::size_t i = 0; i < plot.curves.size(); ++i) {
    const Curve& curve = plot.curves[i];
    script += dataBlock(i, curve);
    draw += fmt::format("{}$data{} using 1:2{} {} title {}", i > 0 ? ", " : "", i,
                        curve.width.empty() ? "" : ":3",
                        styleOf(curve, colours[i % colours.size()]), quoted(curve.label));
  }
  return gnuplot(script + draw + "\n");
}

std::string svgOf(const char* title, const Axis& x, const Axis& y,
                  const std::vector<Curve>& curves) {
  Plot plot;
  plot.title = title;
  plot.x = x;
  plot.y = y;
  plot.curves = curves;
  return svgOf(plot);
}

std::string svgOf(const BarPlot& plot) {
  std::string script = preamble(plot.title, 820, 400) + axis("y", plot.y) +
                       "set boxwidth 0.8\nset xtics rotate by -40\nunset key\n$data << EOD\n";
  std::string names = "set xtics (";
  for (std::size_t i = 0; i < plot.values.size(); ++i) {
    script += fmt::format("{} {}\n", i, plot.values[i]);
    names += fmt::format("{}{} {}", i > 0 ? ", " : "", quoted(plot.names[i]), i);
  }
  return gnuplot(script + "EOD\n" + names +
                 fmt::format(")\nset xrange [-0.6:{}]\nplot $data with boxes lc rgb '{}'\n",
                             static_cast<double>(plot.values.size()) - 0.4, colours[0]));
}

std::string svgOf(const PolarMap& map) {
  const double outer = map.radius.back();
  std::string script = preamble(map.title, 520, 470) + palette();
  script += fmt::format(
      "set style fill solid 1.0 noborder\nset size ratio -1\nunset border\nunset xtics\nunset "
      "ytics\nunset grid\nunset key\n"
      "set view map\nset cblabel {}\nset xlabel {}\nset xrange [{}:{}]\nset yrange [{}:{}]\n",
      quoted(map.valueLabel), quoted(map.radiusLabel), -1.15 * outer, 1.15 * outer, -1.15 * outer,
      1.15 * outer);
  const char* names[] = {"N", "E", "S", "W"};
  for (int i = 0; i < 4; ++i) {
    const double angle = 0.5 * std::numbers::pi * i;
    script += fmt::format("set label {} '{}' at {},{} center front\n", i + 1, names[i],
                          1.08 * outer * std::sin(angle), 1.08 * outer * std::cos(angle));
  }
  for (int ring = 1; ring <= 4; ++ring) {
    const double radius = 0.25 * outer * ring;
    script += fmt::format(
        "set object {0} circle at 0,0 size {1} front fillstyle empty border lc rgb '#bbbbbb'\n"
        "set label {2} '{1:.2g}' at {3},{3} front textcolor rgb '#cccccc' font ',10'\n",
        ring, radius, 10 + ring, radius * std::sqrt(0.5));
  }
  script += "$data << EOD\n";
  const std::size_t count = map.direction_deg.size();
  for (std::size_t r = 0; r < map.radius.size(); ++r) {
    for (std::size_t n = 0; n <= count; ++n) {
      const double angle = map.direction_deg[n % count] * std::numbers::pi / 180.0;
      script += fmt::format("{} {} {}\n", map.radius[r] * std::sin(angle),
                            map.radius[r] * std::cos(angle), map.value[r * count + n % count]);
    }
    script += "\n";
  }
  return gnuplot(script + "EOD\nset pm3d map interpolate 1,1\nsplot $data with pm3d\n");
}

void requirePlotter() { gnuplot("set terminal svg\nplot 0\n"); }

}  // namespace seaway::bridge
