#pragma once

#include <string>
#include <vector>

namespace seaway::bridge {

/// Text with what HTML takes for its own replaced.
std::string htmlEscaped(const std::string& text);

/// A self-contained HTML page of headings, paragraphs, tables, SVG figures and pictures: no script,
/// no link, nothing fetched. Texts are escaped; figures come from plot.h.
class HtmlPage {
 public:
  explicit HtmlPage(const std::string& title);

  void heading(const std::string& text);
  void paragraph(const std::string& text);
  /// Columns after the first are right-aligned.
  void table(const std::vector<std::string>& header,
             const std::vector<std::vector<std::string>>& rows);
  void figure(const std::string& svg, const std::string& caption);

  /// A PNG picture by its bytes.
  void picture(const std::string& png, const std::string& caption);
  /// A line to be copied.
  void code(const std::string& text);

  std::string text() const { return body_ + "</main></body></html>\n"; }

 private:
  std::string body_;
};

}  // namespace seaway::bridge
