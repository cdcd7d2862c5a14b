#include "surface/spectra/readers/read_spectra.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>

#include "surface/input_error.h"
#include "surface/spectra/readers/formats.h"

namespace seaway {
namespace {

using Records = std::vector<SpectrumRecord>;

template <Records (*readOne)(const TextFile&)>
Records oneAfterTheOther(std::span<const TextFile> files) {
  Records all;
  for (const TextFile& file : files) {
    Records records = readOne(file);
    std::move(records.begin(), records.end(), std::back_inserter(all));
  }
  return all;
}

struct Format {
  const char* name;
  const char* summary;
  bool (*looksLike)(const TextFile&);
  Records (*read)(std::span<const TextFile>);
};

using namespace formats;

/// In order of trial: a file is of the first format that it looks like.
constexpr std::array<Format, 7> knownFormats{{
    {"swan", "SWAN spectral file, 1-D or 2-D", looksLikeSwan, oneAfterTheOther<readSwan>},
    {"ww3", "WAVEWATCH III point spectra", looksLikeWavewatch, oneAfterTheOther<readWavewatch>},
    {"triaxys", "TRIAXYS directional or non-directional spectrum", looksLikeTriaxys,
     oneAfterTheOther<readTriaxys>},
    {"spotter", "Spotter JSON, spectra or bulk parameters", looksLikeSpotter,
     oneAfterTheOther<readSpotter>},
    {"ndbc", "NDBC realtime files: data_spec with swdir, swdir2, swr1, swr2", looksLikeNdbcRealtime,
     readNdbcRealtime},
    {"ndbc-yearly", "NDBC historical files with a header row of frequencies", looksLikeNdbcYearly,
     readNdbcYearly},
    {"datawell", "Datawell Waverider .spt", looksLikeDatawell, oneAfterTheOther<readDatawell>},
}};

std::string formatNames() {
  std::string names;
  for (const Format& format : knownFormats) {
    names += (names.empty() ? "" : ", ") + std::string(format.name);
  }
  return names;
}

const Format& formatNamed(const std::string& name) {
  for (const Format& format : knownFormats) {
    if (name == format.name) return format;
  }
  throw InputError("--format: '" + name + "' is not allowed; must be one of: " + formatNames());
}

const Format& formatOf(const TextFile& file) {
  if (file.text.find_first_not_of(" \t\r\n") == std::string::npos) {
    throw InputError(file.name, 0, "holds no spectrum: it is empty");
  }
  for (const Format& format : knownFormats) {
    if (format.looksLike(file)) return format;
  }
  throw InputError(file.name, 0, "is of no format known; give --format, one of: " + formatNames());
}

const Format& formatOf(const std::vector<TextFile>& files) {
  const Format& first = formatOf(files.front());
  for (const TextFile& file : files) {
    const Format& other = formatOf(file);
    if (&other != &first) {
      throw InputError(file.name, 0,
                       "is of format " + std::string(other.name) + ", but " + files.front().name +
                           " of " + first.name + ": they cannot be read together");
    }
  }
  return first;
}

/// Nothing else tells a number that was cut short from a shorter one.
void noteMissingLineEnd(const TextFile& file, Records& records) {
  if (file.text.empty() || file.text.back() == '\n') return;
  SpectrumRecord* last = nullptr;
  for (SpectrumRecord& record : records) {
    const bool later = record.file == file.name && record.line > 0;
    if (later && (!last || record.line > last->line)) last = &record;
  }
  if (last) last->notes.push_back("the file's last line has no end: it may have been cut short");
}

}  // namespace

std::vector<SpectrumFormatName> spectrumFormats() {
  std::vector<SpectrumFormatName> names;
  for (const Format& format : knownFormats) names.push_back({format.name, format.summary});
  return names;
}

std::vector<SpectrumRecord> parseSpectra(const std::vector<TextFile>& files,
                                         const std::string& name) {
  if (files.empty()) throw InputError("no file of spectra is given");
  const Format& format = name.empty() ? formatOf(files) : formatNamed(name);
  Records records = format.read(files);
  if (records.empty()) throw InputError(files.front().name, 0, "holds no spectrum");
  for (SpectrumRecord& record : records) {
    record.format = format.name;
    finishRecord(record);
  }
  for (const TextFile& file : files) noteMissingLineEnd(file, records);
  return records;
}

std::vector<SpectrumRecord> readSpectra(const std::vector<std::filesystem::path>& paths,
                                        const std::string& format) {
  std::vector<TextFile> files;
  for (const std::filesystem::path& path : paths) files.push_back(readTextFile(path));
  return parseSpectra(files, format);
}

std::vector<SpectrumRecord> readSpectra(const std::filesystem::path& path,
                                        const std::string& format) {
  return readSpectra(std::vector<std::filesystem::path>{path}, format);
}

std::vector<std::filesystem::path> withCompanions(const std::filesystem::path& path) {
  namespace fs = std::filesystem;
  std::vector<fs::path> paths{path};
  const auto addIfThere = [&](const fs::path& candidate) {
    std::error_code ignored;
    if (fs::is_regular_file(candidate, ignored)) paths.push_back(candidate);
  };
  if (path.extension() == ".data_spec") {
    for (const char* extension : {".swdir", ".swdir2", ".swr1", ".swr2"}) {
      addIfThere(fs::path(path).replace_extension(extension));
    }
    return paths;
  }
  // Station (5 characters), w, year.
  const std::string stem = path.stem().string();
  const bool yearly = stem.size() == 10 && stem[5] == 'w' && path.extension() == ".txt" &&
                      std::all_of(stem.begin() + 6, stem.end(),
                                  [](unsigned char c) { return std::isdigit(c) != 0; });
  if (yearly) {
    for (const char kind : {'d', 'i', 'j', 'k'}) {
      std::string name = stem;
      name[5] = kind;
      addIfThere(path.parent_path() / (name + ".txt"));
    }
  }
  return paths;
}

}  // namespace seaway
