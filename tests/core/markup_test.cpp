#include "wardslam/core/markup.h"

#include <gtest/gtest.h>

namespace wardslam::core {
namespace {

TEST(Markup, EscapesWhatEndsTextsAndAttributes) {
  EXPECT_EQ(escapedForMarkup(R"(<b a="1" c='2'>&amp;</b>)"),
            "&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt;&amp;amp;&lt;/b&gt;");
}

TEST(Markup, LeavesTheRestAsItIs) {
  EXPECT_EQ(escapedForMarkup(""), "");
  EXPECT_EQ(escapedForMarkup("Zimmer 4, Süd"), "Zimmer 4, Süd");
}

}  // namespace
}  // namespace wardslam::core
