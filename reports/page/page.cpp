#include "page/page.h"

#include <cstdint>

namespace morula {
namespace {

/// Returns the page's content security policy. The file holds everything, so all requests are forbidden, and only these
/// very programs may run.
std::string policy(const Page& page) {
  std::string text =
      "default-src 'none'; img-src data:; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'";
  if (page.program.empty()) return text;
  text += "; script-src 'sha256-" + base64(sha256(page.program)) + "'";
  if (page.runsAgain) text += " 'wasm-unsafe-eval'; worker-src blob:";
  return text;
}

std::string commandsHtml(const std::vector<std::string>& commands) {
  if (commands.empty()) return {};
  std::string html = "<div class=\"again\"><span>Make this again:</span>";
  for (const std::string& command : commands) html += "<code>" + htmlText(command) + "</code>";
  return html + "</div>\n";
}

}  // namespace

std::string htmlText(std::string_view text) {
  std::string html;
  html.reserve(text.size());
  for (const char c : text) switch (c) {
      case '&': html += "&amp;"; break;
      case '<': html += "&lt;"; break;
      case '>': html += "&gt;"; break;
      case '"': html += "&quot;"; break;
      case '\'': html += "&#39;"; break;
      default: html += c;
    }
  return html;
}

std::string scriptJson(std::string_view json) {
  std::string text;
  text.reserve(json.size());
  for (std::size_t i = 0; i < json.size(); ++i) {
    const std::string_view rest = json.substr(i, 3);
    if (json[i] == '<') text += "\\u003c";
    else if (json[i] == '>') text += "\\u003e";
    else if (json[i] == '&') text += "\\u0026";
    else if (rest == "\xe2\x80\xa8" || rest == "\xe2\x80\xa9") {
      text += rest[2] == '\xa8' ? "\\u2028" : "\\u2029";
      i += 2;
    } else text += json[i];
  }
  return text;
}

std::string dataUri(std::string_view type, std::string_view bytes) {
  return "data:" + std::string(type) + ";base64," + base64(bytes);
}

std::string pageFile(const Page& page) {
  std::string html =
      "<!DOCTYPE html>\n<!-- Morula report -->\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"" +
      htmlText(policy(page)) +
      "\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<link rel=\"icon\" href=\"data:,\">\n<title>" +
      htmlText(page.title) + "</title>\n<style>\n" + pageStyle() + "</style>\n</head>\n<body>\n<header>\n<h1>" +
      htmlText(page.title) + "</h1>\n";
  if (!page.summary.empty()) html += "<p class=\"summary\">" + htmlText(page.summary) + "</p>\n";
  html += "</header>\n<main>\n<section id=\"verdict\" aria-label=\"Verdict\">\n" + page.verdict + "</section>\n";
  for (const PageBlock& block : page.blocks)
    html += "<section id=\"" + block.id + "\">\n<h2>" + htmlText(block.title) + "</h2>\n" + block.html +
            commandsHtml(block.commands) + "</section>\n";
  html += "</main>\n";
  if (!page.command.empty())
    html += "<footer>\n<div class=\"again\"><span>Make this page again:</span><code>" + htmlText(page.command) +
            "</code></div>\n</footer>\n";
  if (!page.program.empty() && !page.data.empty()) {
    html += "<script type=\"application/json\" id=\"data\">" + scriptJson(page.data) + "</script>\n";
    for (const PageBytes& bytes : page.bytes)
      html += "<script type=\"text/plain\" id=\"" + bytes.id + "\">" + base64(bytes.bytes) + "</script>\n";
  }
  if (!page.program.empty()) html += "<script>" + page.program + "</script>\n";
  return html + "</body>\n</html>\n";
}

}  // namespace morula
