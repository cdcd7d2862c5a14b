#include "sim_bridge/report/html_page.h"

#include <absl/strings/escaping.h>

namespace seaway::bridge {

std::string htmlEscaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

namespace {

constexpr const char* style =
    "body{font:16px/1.5 sans-serif;color:#222;background:#fff;margin:0}"
    "main{max-width:56rem;margin:2rem auto;padding:0 1rem}"
    "table{border-collapse:collapse;margin:1rem 0}"
    "th,td{padding:.25rem .9rem;border-bottom:1px solid #ddd;text-align:right}"
    "th:first-child,td:first-child{text-align:left}"
    "figure{margin:1.5rem 0}figure svg,figure "
    "img{max-width:100%;height:auto}pre{overflow:auto;background:#f4f4f4;padding:.5rem}"
    "figcaption{color:#555;font-size:.9rem}h1{font-size:1.6rem}h2{font-size:1.2rem}";

std::string row(const std::vector<std::string>& cells, const std::string& tag) {
  std::string result = "<tr>";
  for (const std::string& cell : cells)
    result += "<" + tag + ">" + htmlEscaped(cell) + "</" + tag + ">";
  return result + "</tr>\n";
}

}  // namespace

HtmlPage::HtmlPage(const std::string& title)
    : body_("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" +
            htmlEscaped(title) + "</title><style>" + style + "</style></head><body><main>\n<h1>" +
            htmlEscaped(title) + "</h1>\n") {}

void HtmlPage::heading(const std::string& text) { body_ += "<h2>" + htmlEscaped(text) + "</h2>\n"; }

void HtmlPage::paragraph(const std::string& text) { body_ += "<p>" + htmlEscaped(text) + "</p>\n"; }

void HtmlPage::table(const std::vector<std::string>& header,
                     const std::vector<std::vector<std::string>>& rows) {
  body_ += "<table>" + row(header, "th");
  for (const auto& cells : rows) body_ += row(cells, "td");
  body_ += "</table>\n";
}

void HtmlPage::figure(const std::string& svg, const std::string& caption) {
  body_ += "<figure>" + svg + "<figcaption>" + htmlEscaped(caption) + "</figcaption></figure>\n";
}

void HtmlPage::picture(const std::string& png, const std::string& caption) {
  body_ += "<figure><img alt=\"\" src=\"data:image/png;base64," + absl::Base64Escape(png) +
           "\"><figcaption>" + htmlEscaped(caption) + "</figcaption></figure>\n";
}

void HtmlPage::code(const std::string& text) { body_ += "<pre>" + htmlEscaped(text) + "</pre>\n"; }

}  // namespace seaway::bridge
