#include "surface/spectra/readers/text_file.h"

#include <fstream>
#include <iterator>

#include "surface/input_error.h"

namespace seaway {

TextFile readTextFile(const std::filesystem::path& path) {
  namespace fs = std::filesystem;
  std::error_code fault;
  const fs::file_status status = fs::status(path, fault);
  std::ifstream file;
  if (fs::is_regular_file(status) || fs::is_fifo(status)) file.open(path, std::ios::binary);
  if (!file.is_open()) throw InputError(path.string(), 0, "cannot be read");
  TextFile result{path.string(), {}};
  result.text.assign(std::istreambuf_iterator<char>(file), {});
  if (file.bad()) throw InputError(path.string(), 0, "cannot be read");
  return result;
}

}  // namespace seaway
