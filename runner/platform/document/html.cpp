// Writes documents as HTML. Every text of a document passes through `safe` exactly once.
#include <fmt/format.h>

#include <regex>

#include "document/document.h"
#include "files/printable.h"
#include "page/page.h"

namespace morula {
namespace {

/// Returns a text as HTML: markup is shown as text, and invisible characters are made visible.
std::string safe(std::string_view text) { return htmlText(printable(text)); }

/// Returns prose as HTML: browsers break 4.8e-07 behind its hyphen, so such numbers are kept whole.
std::string prose(std::string_view text) {
  static const std::regex power("[0-9][0-9.]*e[-+][0-9]+");
  return std::regex_replace(safe(text), power, "<span class=\"whole\">$&</span>");
}

std::string element(const std::string& tag, const std::string& attributes, const std::string& html) {
  return "<" + tag + attributes + ">" + html + "</" + tag + ">";
}

std::string ofClass(const std::string& name) { return " class=\"" + name + "\""; }

std::string htmlOf(const Words::Piece& piece) {
  const std::string text = safe(piece.text);
  const auto marked = [&](const char* kind) {
    const std::string hint = piece.hint.empty() ? "" : " title=\"" + safe(piece.hint) + "\"";
    return element("span", ofClass(std::string("mark ") + kind) + hint, text);
  };
  switch (piece.emphasis) {
    case Emphasis::bold: return element("b", "", text);
    case Emphasis::italic: return element("i", "", text);
    case Emphasis::code: return element("code", "", text);
    case Emphasis::quiet: return element("span", ofClass("note"), text);
    case Emphasis::subscript: return element("sub", "", text);
    case Emphasis::good: return marked("good");
    case Emphasis::warning: return marked("warn");
    case Emphasis::bad: return marked("bad");
    case Emphasis::link: return element("a", " href=\"#" + safe(piece.hint) + "\"", text);
    case Emphasis::lineBreak: return "<br>";
    case Emphasis::plain: break;
  }
  return prose(piece.text);
}

/// Returns a cell as HTML. A hash may be broken anywhere, words may not.
std::string cellHtml(const Words& words) {
  const std::string text = words.text();
  const bool isLong = text.find(' ') == text.npos && text.size() > 24;
  return isLong ? element("span", ofClass("long"), htmlOf(words)) : htmlOf(words);
}

/// Returns the attributes of a table's cell: a number must not be broken into lines.
std::string cellAttributes(const Words& words) {
  constexpr std::size_t longest = 16;
  const std::string text = words.text();
  const bool isNumber = text.size() <= longest && text.find_first_of("0123456789") != text.npos &&
                        text.find_first_not_of("0123456789.,+-/e%") == text.npos;
  return isNumber ? ofClass("number") : "";
}

std::string figure(const Picture& p) {
  return "<figure><img src=\"" + dataUri(p.type, p.bytes) + "\" alt=\"" + safe(p.what) + "\"><figcaption>" +
         safe(p.caption) + "</figcaption></figure>\n";
}

struct AsHtml {
  std::string operator()(const Sentence& s) const {
    const std::string words = htmlOf(s.words);
    switch (s.kind) {
      case Sentence::Kind::heading: return element("h3", "", words) + "\n";
      case Sentence::Kind::part: return element("h2", "", words) + "\n";
      case Sentence::Kind::first: return element("p", ofClass("said"), words) + "\n";
      case Sentence::Kind::note: return element("p", ofClass("note"), words) + "\n";
      case Sentence::Kind::plain: break;
    }
    return element("p", "", words) + "\n";
  }

  std::string operator()(const FindingList& f) const {
    struct Appearance {
      Finding::Kind kind;
      const char *name, *mark;
    };
    static constexpr Appearance worstFirst[] = {{Finding::Kind::bad, "bad", "✗ Fault"},
                                                {Finding::Kind::warning, "warn", "! Warning"},
                                                {Finding::Kind::note, "plain", "–"},
                                                {Finding::Kind::good, "good", "✓"}};
    std::string html;
    for (const Appearance& as : worstFirst)
      for (const Finding& finding : f.list) {
        if (finding.kind != as.kind) continue;
        std::string why;
        for (const std::string& clause : finding.why) why += element("li", "", prose(clause));
        html += element("li", ofClass(as.name),
                        element("span", ofClass(std::string("mark ") + as.name), as.mark) + htmlOf(finding.words) +
                            (why.empty() ? "" : element("ul", ofClass("why"), why))) +
                "\n";
      }
    return element("ul", ofClass("findings"), "\n" + html) + "\n";
  }

  std::string operator()(const PlainList& items) const {
    std::string html;
    for (const Words& words : items.list) html += element("li", "", htmlOf(words)) + "\n";
    return element("ul", "", "\n" + html) + "\n";
  }

  std::string operator()(const Verbatim& v) const {
    const std::string html =
        element("pre", " tabindex=\"0\"", safe(std::string_view(v.text).substr(0, v.maxBytes))) + "\n";
    if (v.text.size() <= v.maxBytes) return html;
    return html +
           (*this)(Sentence{fmt::format("The first {} of {} bytes.", v.maxBytes, v.text.size()), Sentence::Kind::note});
  }

  std::string operator()(const Table& table) const {
    std::string head, body;
    for (const Column& column : table.columns)
      if (column.isShown)
        head += column.title.empty() ? "<td></td>" : element("th", " scope=\"col\"", htmlOf(column.title));
    for (const auto& row : table.rows) {
      std::string cells;
      for (std::size_t i = 0; i < row.size(); ++i)
        if (i >= table.columns.size() || table.columns[i].isShown)
          cells += cells.empty() ? element("th", " scope=\"row\"", htmlOf(row[i].words))
                                 : element("td", cellAttributes(row[i].words), cellHtml(row[i].words));
      body += element("tr", "", cells) + "\n";
    }
    const std::string caption = safe(table.caption);
    return "<div class=\"wide\" tabindex=\"0\" role=\"group\" aria-label=\"" + caption + "\"><table>\n<caption>" +
           caption + "</caption>\n" + (head.empty() ? "" : "<thead><tr>" + head + "</tr></thead>\n") + "<tbody>\n" +
           body + "</tbody></table></div>\n";
  }

  std::string operator()(const Picture& p) const {
    std::string attributes;
    if (p.size == Picture::Size::large)
      attributes = ofClass("large") + " tabindex=\"0\" role=\"region\" aria-label=\"" + safe(p.what) + "\"";
    if (p.size == Picture::Size::wide) attributes = ofClass("double");
    if (!p.id.empty()) attributes += " id=\"" + p.id + "\"";
    if (!p.name.empty()) attributes += " data-picture=\"" + p.name + "\"";
    return attributes.empty() ? figure(p) : element("div", attributes, figure(p)) + "\n";
  }

  std::string operator()(const Swipe& s) const {
    return "<div class=\"compare\" data-first=\"" + s.first + "\" data-second=\"" + s.second + "\" data-names=\"" +
           safe(s.titles) + "\"></div>\n";
  }

  std::string operator()(const LineKey& key) const {
    std::string html;
    for (const auto& [colour, isDashed, words] : key.lines)
      html += fmt::format("<li><i class=\"{}\" style=\"color: #{:02x}{:02x}{:02x}\"></i>{}</li>\n",
                          isDashed ? "dashed" : "solid", colour.r, colour.g, colour.b, htmlOf(words));
    return element("ul", ofClass("key"), "\n" + html) + "\n";
  }

  std::string operator()(const Downloads& downloads) const {
    std::string html;
    for (const auto& [name, type, bytes] : downloads.files)
      html += "<a download=\"" + safe(name) + "\" href=\"" + dataUri(type, bytes) + "\">" + safe(name) + " " +
              htmlOf(quiet("(" + inBytes(bytes.size()) + ")")) + "</a>\n";
    return element("div", ofClass("downloads"), "\n" + html) + "\n";
  }

  std::string operator()(const ExplorerPlace&) const {
    return "<noscript><p>The explorer needs JavaScript; the pictures below do without.</p></noscript>\n<div "
           "id=\"explore\"></div>\n";
  }

  std::string operator()(const ProgramPlace& place) const {
    return element("div", " id=\"" + place.id + "\"",
                   place.without.empty() ? "" : element("p", "", safe(place.without))) +
           "\n";
  }

  std::string operator()(const Group& group) const {
    const std::string body = htmlOf(group.body);
    if (group.kind == Group::Kind::folded)
      return element("details", "", element("summary", "", safe(group.title)) + "\n" + body) + "\n";
    return element("div", ofClass(group.kind == Group::Kind::charts ? "charts" : "pictures"), "\n" + body) + "\n";
  }
};

}  // namespace

std::string htmlOf(const Words& words) {
  std::string html;
  for (const Words::Piece& piece : words.pieces()) html += htmlOf(piece);
  return html;
}

std::string htmlOf(const Document& document) {
  std::string html;
  for (const Block& block : document.blocks) html += std::visit(AsHtml{}, block);
  return html;
}

}  // namespace morula
