// SPDX-License-Identifier: Apache-2.0
#include "runs/report/text.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace pacer::report {
namespace {

TEST(Text, IsShownAndNeverObeyed) {
  EXPECT_EQ(Text("<img onerror=x>").html(), "&lt;img onerror=x&gt;");
  EXPECT_EQ(Text::code("a<b").html(), "<code>a&lt;b</code>");
  EXPECT_EQ(Text::strong("a&b").html(), "<strong>a&amp;b</strong>");
}

TEST(Text, PiecesJoin) {
  const Text text = Text("seed ") + Text::code("7");
  EXPECT_EQ(text.html(), "seed <code>7</code>");
  EXPECT_EQ(text.plain(), "seed 7");
}

TEST(Text, LinksLeadToThePageOrBesideIt) {
  EXPECT_EQ(Text::link("scores", "#scores").html(), "<a href=\"#scores\">scores</a>");
  EXPECT_EQ(Text::link("rules", "out/my rules.txt").html(),
            "<a href=\"out/my%20rules.txt\">rules</a>");
}

TEST(Text, LinksLeadNowhereElse) {
  for (const char* target : {"", "javascript:alert(1)", "http://a.b/c", "//a.b/c", "/etc/passwd",
                             "JavaScript:x", "data:text/html,x"}) {
    EXPECT_THROW((void)Text::link("x", target), std::invalid_argument) << target;
  }
}

TEST(Text, ALinkCannotLeaveItsAttribute) {
  EXPECT_EQ(Text::link("x", "a\" onclick=\"b").html(), "<a href=\"a%22%20onclick%3D%22b\">x</a>");
}

TEST(Text, ASwatchTakesOnlyAColour) {
  EXPECT_EQ(Text::swatch("#4477AA").html(),
            "<i class=\"swatch\" style=\"background:#4477AA\"></i>");
  EXPECT_THROW((void)Text::swatch("red;}"), std::invalid_argument);
  EXPECT_THROW((void)Text::swatch("#12345\""), std::invalid_argument);
}

}  // namespace
}  // namespace pacer::report
