// Texts in a page never become markup, and its policy knows the explorer's bytes.
#include "page/page.h"

#include "catch.h"

namespace morula {
namespace {

std::string hex(const std::string& bytes) {
  static constexpr char digits[] = "0123456789abcdef";
  std::string text;
  for (const char c : bytes) text += {digits[static_cast<unsigned char>(c) >> 4], digits[c & 15]};
  return text;
}

TEST_CASE("Markup in a text is text") {
  CHECK(htmlText("<a href=\"x\" title='y'>&</a>") == "&lt;a href=&quot;x&quot; title=&#39;y&#39;&gt;&amp;&lt;/a&gt;");
}

TEST_CASE("JSON in a script element cannot end it") {
  CHECK(scriptJson("{\"a\": \"</script><!-- & \xe2\x80\xa8\xe2\x80\xa9\xe2\x82\xac\"}") ==
        "{\"a\": \"\\u003c/script\\u003e\\u003c!-- \\u0026 \\u2028\\u2029\xe2\x82\xac\"}");
  CHECK(scriptJson("\xe2\x80") == "\xe2\x80");  // cut off at the end
}

TEST_CASE("Base64 [RFC 4648, §10]") {
  CHECK(base64("") == "");
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foo") == "Zm9v");
  CHECK(base64("foob") == "Zm9vYg==");
  CHECK(base64("fooba") == "Zm9vYmE=");
  CHECK(base64("foobar") == "Zm9vYmFy");
  CHECK(base64("\xff\xfe\xfd") == "//79");
}

TEST_CASE("SHA-256 [FIPS 180-4, the examples of NIST]") {
  CHECK(hex(sha256("")) == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(hex(sha256("abc")) == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(hex(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq")) ==
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  CHECK(hex(sha256(std::string(1'000'000, 'a'))) == "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

Page smallPage() {
  return {.title = "<b>",
          .summary = "</p><script>alert(1)</script>",
          .verdict = "<p>fine</p>",
          .blocks = {{"one", "A & B", "<p>x</p>", {"morula run '<x>'"}}},
          .data = "{\"a\": \"</script>\"}",
          .bytes = {{"frames-0", "foo"}},
          .command = "morula report '<y>'",
          .program = "alert(2)"};
}

TEST_CASE("A page runs its own program and no other, and asks for nothing") {
  const std::string page = pageFile(smallPage());
  CHECK(page == pageFile(smallPage()));
  CHECK_THAT(page, ContainsSubstring("default-src &#39;none&#39;"));
  CHECK_THAT(page, ContainsSubstring("script-src &#39;sha256-" + base64(sha256("alert(2)")) + "&#39;"));
  CHECK_THAT(page, !ContainsSubstring("<script>alert(1)"));
  CHECK_THAT(page, !ContainsSubstring("<b>"));
  CHECK_THAT(page, ContainsSubstring("<h2>A &amp; B</h2>"));
  CHECK_THAT(page, ContainsSubstring("<code>morula run &#39;&lt;x&gt;&#39;</code>"));
  CHECK_THAT(page, ContainsSubstring("<footer>"));
  CHECK_THAT(page, ContainsSubstring("<code>morula report &#39;&lt;y&gt;&#39;</code>"));
  CHECK_THAT(page, ContainsSubstring("id=\"frames-0\">Zm9v</script>"));
  CHECK_THAT(page, ContainsSubstring("\\u003c/script\\u003e"));
}

TEST_CASE("Without the explorer no program may run") {
  Page page = smallPage();
  page.program.clear();
  const std::string bytes = pageFile(page);
  CHECK_THAT(bytes, !ContainsSubstring("script-src"));
  CHECK_THAT(bytes, !ContainsSubstring("<script"));
}

}  // namespace
}  // namespace morula
