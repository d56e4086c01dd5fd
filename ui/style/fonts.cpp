#include "ui/style/fonts.hpp"

#include "ui/style/icons.hpp"

#include <imgui.h>
#include <imgui_freetype.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iterator>

namespace forefront {

namespace {

// Latin, Greek (α δ ρ Γ Ω), punctuation, super- and subscripts, arrows, mathematics, shapes.
const ImWchar kTextRanges[] = {0x0020, 0x017f, 0x0391, 0x03c9, 0x2010, 0x2027, 0x202f, 0x203a,
                               0x2070, 0x2094, 0x2190, 0x2195, 0x21e7, 0x21e7, 0x2202, 0x2202,
                               0x2205, 0x2265, 0x2318, 0x2318, 0x25a0, 0x25cf, 0};
const ImWchar kAllLatin[] = {0x0020, 0x017f, 0x2010, 0x2027, 0};

/// The icons in use, each a range of its own. Rasterising all of Font Awesome would make loading the fonts take three
/// times as long.
constexpr auto kIconRanges = [] {
    std::array<ImWchar, 2 * std::size(icon::kAll) + 1> ranges{};
    for (std::size_t i = 0; i < std::size(icon::kAll); ++i) {
        const char *const utf8 = icon::kAll[i]; // three bytes
        const int code = ((utf8[0] & 0x0f) << 12) | ((utf8[1] & 0x3f) << 6) | (utf8[2] & 0x3f);
        ranges[2 * i] = ranges[2 * i + 1] = static_cast<ImWchar>(code);
    }
    return ranges; // ends with 0
}();

class AtlasBuilder {
  public:
    AtlasBuilder(float scale, std::string &warning) : scale_(scale), warning_(warning) {}

    /// Adds a text font at `size` design pixels. Symbols it lacks come from DejaVu; icons are added on request.
    ImFont *text(const char *file, float size, bool withIcons) {
        ImFont *font = add(file, size, kTextRanges, nullptr);
        if (font == nullptr) {
            font = add("truetype/dejavu/DejaVuSans.ttf", size, kTextRanges, nullptr);
        }
        if (font == nullptr) {
            ImFontConfig config;
            config.SizePixels = std::round(size * scale_);
            font = atlas().AddFontDefault(&config);
        } else {
            ImFontConfig merge;
            merge.MergeMode = true;
            add("truetype/dejavu/DejaVuSans.ttf", size, kTextRanges, &merge);
        }
        if (withIcons) {
            ImFontConfig merge;
            merge.MergeMode = true;
            merge.GlyphOffset.y = std::round(0.5F * scale_);
            add("truetype/font-awesome/fontawesome-webfont.ttf", size, kIconRanges.data(), &merge);
        }
        return font;
    }

    ImFont *icons(float size) {
        return add("truetype/font-awesome/fontawesome-webfont.ttf", size, kIconRanges.data(), nullptr);
    }

    ImFont *mono(float size) { return add("truetype/dejavu/DejaVuSansMono.ttf", size, kAllLatin, nullptr); }

  private:
    static ImFontAtlas &atlas() { return *ImGui::GetIO().Fonts; }

    ImFont *add(const char *file, float size, const ImWchar *ranges, const ImFontConfig *config) {
        const std::filesystem::path path = std::filesystem::path(FOREFRONT_FONT_ROOT) / file;
        std::error_code ignored;
        if (!std::filesystem::exists(path, ignored)) {
            if (warning_.empty()) {
                warning_ = "font " + path.string() +
                           " not found; install fonts-inter, fonts-font-awesome and fonts-dejavu-core";
            }
            return nullptr;
        }
        return atlas().AddFontFromFileTTF(path.c_str(), std::round(size * scale_), config, ranges);
    }

    float scale_;
    std::string &warning_;
};

/// Gives all digits the width of the widest and centres them in it. FreeType within Dear ImGui does not apply the
/// OpenType feature "tnum" that would do the same.
void makeDigitsTabular(ImFont &font) {
    float widest = 0.0F;
    for (ImWchar digit = '0'; digit <= '9'; ++digit) {
        widest = std::max(widest, font.GetCharAdvance(digit));
    }
    for (ImWchar digit = '0'; digit <= '9'; ++digit) {
        const ImFontGlyph *const found = font.FindGlyphNoFallback(digit);
        if (found == nullptr) {
            continue;
        }
        ImFontGlyph &glyph = font.Glyphs[static_cast<int>(found - font.Glyphs.Data)];
        const float shift = std::round(0.5F * (widest - glyph.AdvanceX)); // whole pixels keep the digit sharp
        glyph.X0 += shift;
        glyph.X1 += shift;
        glyph.AdvanceX = widest;
        font.IndexAdvanceX[digit] = widest;
    }
}

} // namespace

Fonts loadFonts(float scale, std::string &warning) {
    ImFontAtlas &atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
    atlas.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
    atlas.TexGlyphPadding = 1;
    AtlasBuilder builder(scale, warning);
    Fonts fonts;
    fonts.body = builder.text("opentype/inter/Inter-Regular.otf", 14.0F, true);
    fonts.strong = builder.text("opentype/inter/Inter-SemiBold.otf", 14.0F, true);
    fonts.small = builder.text("opentype/inter/Inter-Regular.otf", 13.0F, true);
    fonts.heading = builder.text("opentype/inter/Inter-SemiBold.otf", 13.0F, true);
    fonts.title = builder.text("opentype/inter/Inter-SemiBold.otf", 20.0F, false);
    fonts.icons = builder.icons(17.0F);
    fonts.mono = builder.mono(13.0F);
    fonts.icons = fonts.icons != nullptr ? fonts.icons : fonts.body;
    fonts.mono = fonts.mono != nullptr ? fonts.mono : fonts.body;
    ImGui::GetIO().FontDefault = fonts.body;
    atlas.Build();
    for (ImFont *font : atlas.Fonts) {
        makeDigitsTabular(*font);
    }
    return fonts;
}

} // namespace forefront
