// SPDX-License-Identifier: Apache-2.0
#include "runs/report/escape.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "core/random.h"

namespace pacer::report {
namespace {

TEST(EscapeHtml, LeavesNoMarkup) {
  EXPECT_EQ(escape_html("<b a=\"1\" b='2'>&amp;"),
            "&lt;b a=&quot;1&quot; b=&#39;2&#39;&gt;&amp;amp;");
}

TEST(EscapeHtml, KeepsWellFormedUtf8) {
  EXPECT_EQ(escape_html("Gr\xC3\xBC\xC3\x9F \xE2\x82\xAC \xF0\x9F\x9A\x97"),
            "Gr\xC3\xBC\xC3\x9F \xE2\x82\xAC \xF0\x9F\x9A\x97");
}

TEST(EscapeHtml, ReplacesWhatIsNoUtf8) {
  EXPECT_EQ(escape_html("a\xFFz"), "a\xEF\xBF\xBDz");
  EXPECT_EQ(escape_html("\xC3"), "\xEF\xBF\xBD") << "cut in the middle of a character";
  EXPECT_EQ(escape_html("\xC0\xBC"), "\xEF\xBF\xBD\xEF\xBF\xBD") << "an overlong <";
  EXPECT_EQ(escape_html("\xED\xA0\x80").find('\xED'), std::string::npos) << "a surrogate";
  EXPECT_EQ(escape_html("\xF4\x90\x80\x80").find('\xF4'), std::string::npos) << "above U+10FFFF";
}

TEST(EscapeHtml, ReplacesControlCharacters) {
  EXPECT_EQ(escape_html(std::string("a\0\x1B[31m\tb\n", 10)), "a\xEF\xBF\xBD\xEF\xBF\xBD[31m\tb\n");
}

TEST(EscapeHtml, AnyBytesAreTakenAndNoneOfThemIsMarkup) {
  Random random(5);
  for (int i = 0; i < 2000; ++i) {
    std::string text(random.below(12), ' ');
    for (char& c : text) c = static_cast<char>(random.below(256));
    EXPECT_EQ(escape_html(text).find_first_of("<>\"'"), std::string::npos);
  }
}

TEST(EscapeJson, NothingEndsTheScriptElement) {
  const nlohmann::json hostile = {{"</script><script>alert(1)</script>", "<!-- & \xE2\x80\xA8"}};
  const std::string text = escape_json(hostile);
  EXPECT_EQ(text.find_first_of("<>&"), std::string::npos);
  EXPECT_EQ(text.find("\xE2\x80\xA8"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(text), hostile) << "and it means the same";
}

TEST(EscapeJson, BadUtf8AndNanAreStillValidJson) {
  const nlohmann::json value = {"\xFF", std::numeric_limits<double>::quiet_NaN()};
  EXPECT_EQ(escape_json(value), "[\"\xEF\xBF\xBD\",null]");
}

TEST(Base64, GivesTheStandardsExamples) {
  const auto of = [](std::string_view text) {
    return base64(std::vector<std::uint8_t>(text.begin(), text.end()));
  };
  EXPECT_EQ(of(""), "");
  EXPECT_EQ(of("f"), "Zg==");
  EXPECT_EQ(of("fo"), "Zm8=");
  EXPECT_EQ(of("foo"), "Zm9v");
  EXPECT_EQ(of("foobar"), "Zm9vYmFy");
  EXPECT_EQ(of("\xFB\xFF\xBF"), "+/+/");
}

}  // namespace
}  // namespace pacer::report
