#include "core/teaching/film/stroke_font.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace forefront {

namespace {

/// A character as polylines between points of a lattice: two digits each, column and row, with row 2 on the baseline, 6
/// at x-height and 8 at cap height. Spaces lift the pen; a lone point is a dot.
struct Glyph {
    std::string_view character, strokes;
};

constexpr Glyph kGlyphs[] = {
    {"!", "0804 02"},
    {"\"", "0806 1816"},
    {"#", "1218 3238 0444 0646"},
    {"$", "4738180716354433321203 2921"},
    {"%", "0248 0818 3242"},
    {"&", "4205072817160403122245"},
    {"'", "0806"},
    {"(", "18060412"},
    {")", "08161402"},
    {"*", "2723 0446 4406"},
    {"+", "2723 0545"},
    {",", "0301"},
    {"-", "0535"},
    {".", "02"},
    {"/", "0138"},
    {"0", "183847433212030718"},
    {"1", "072822 0242"},
    {"2", "0718384746020242"},
    {"3", "07183847463515354443321203"},
    {"4", "3238380444"},
    {"5", "480805354443321203"},
    {"6", "473818070312324344351504"},
    {"7", "084822"},
    {"8", "15354647381807061504031232434435"},
    {"9", "031232434738180706153546"},
    {":", "03 06"},
    {";", "0301 06"},
    {"<", "370533"},
    {"=", "0444 0646"},
    {">", "073503"},
    {"?", "071838474624 22"},
    {"@", "33232435334347381807031242"},
    {"A", "022842 0444"},
    {"B", "02083847463505 3544433202"},
    {"C", "4738180703123243"},
    {"D", "02082847432202"},
    {"E", "48080242 0535"},
    {"F", "480802 0535"},
    {"G", "47381807031232434424"},
    {"H", "0208 4248 0545"},
    {"I", "0802"},
    {"J", "484332120304"},
    {"K", "0208 480542"},
    {"L", "080242"},
    {"M", "0208254842"},
    {"N", "02084248"},
    {"O", "183847433212030718"},
    {"P", "02083847463505"},
    {"Q", "183847433212030718 2442"},
    {"R", "02083847463505 2542"},
    {"S", "47381807061535444332120304"},
    {"T", "0848 2822"},
    {"U", "080312324348"},
    {"V", "082248"},
    {"W", "0812263248"},
    {"X", "0248 0842"},
    {"Y", "082548 2522"},
    {"Z", "08480242"},
    {"[", "18080212"},
    {"\\", "0831"},
    {"]", "08181202"},
    {"^", "062846"},
    {"_", "0141"},
    {"`", "0817"},
    {"a", "0516263532 341403122233"},
    {"b", "0802 0516263533221203"},
    {"c", "3526160503122233"},
    {"d", "3832 3526160503122233"},
    {"e", "04343526160503122233"},
    {"f", "28181712 0626"},
    {"g", "3631201001 3526160503122233"},
    {"h", "0802 0516263532"},
    {"i", "0602 08"},
    {"j", "161100 18"},
    {"k", "0802 360432"},
    {"l", "0802"},
    {"m", "0206 05162522 25364542"},
    {"n", "0206 0516263532"},
    {"o", "162635332212030516"},
    {"p", "0006 0516263533221203"},
    {"q", "3036 3526160503122233"},
    {"r", "0206 051626"},
    {"s", "35261605142433221203"},
    {"t", "08031222 0626"},
    {"u", "0603122233 3632"},
    {"v", "062236"},
    {"w", "0612243246"},
    {"x", "0236 0632"},
    {"y", "0622 3600"},
    {"z", "06360232"},
    {"{", "28181605141222"},
    {"|", "0901"},
    {"}", "08181625141202"},
    {"~", "04152435"},
    {"\xc2\xb0", "0818170708"},                  // degree
    {"\xc2\xb7", "15"},                          // middle dot
    {"\xc3\x97", "0335 0533"},                   // times
    {"\xce\x93", "020848"},                      // capital gamma
    {"\xce\xb1", "463422120305162442"},          // alpha
    {"\xce\xb4", "381807162635332212030516"},    // delta
    {"\xcf\x81", "000516263533221203"},          // rho
    {"\xe2\x80\x93", "0535"},                    // en dash
    {"\xe2\x80\xa6", "02 22 42"},                // ellipsis
    {"\xe2\x86\x92", "0545 364534"},             // arrow to the right
    {"\xe2\x88\x85", "163645433212030516 0246"}, // empty set
};
constexpr std::string_view kUnknown = "0208484202"; // a box

constexpr double kGap = 1.6, kSpace = 3.0; // units: gap between characters, width of a space

std::string_view strokesOf(std::string_view character) {
    const auto *const found = std::find_if(std::begin(kGlyphs), std::end(kGlyphs),
                                           [&](const Glyph &glyph) { return glyph.character == character; });
    return found == std::end(kGlyphs) ? kUnknown : found->strokes;
}

/// Calls use(strokes) for each character of a text; a space has no strokes.
template <class Use>
void forCharacters(std::string_view text, Use use) {
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = at + 1;
        while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) {
            ++end; // a continuation byte of UTF-8
        }
        const std::string_view character = text.substr(at, end - at);
        use(character == " " ? std::string_view() : strokesOf(character));
        at = end;
    }
}

Vec2 latticePoint(char column, char row) {
    return {static_cast<double>(column - '0'), static_cast<double>(row - '2')};
}

double widthOf(std::string_view strokes) {
    double width = strokes.empty() ? kSpace - kGap : 0.0;
    for (std::size_t k = 0; k + 1 < strokes.size();) {
        if (strokes[k] == ' ') {
            ++k;
            continue;
        }
        width = std::max(width, latticePoint(strokes[k], '0').x);
        k += 2;
    }
    return width;
}

void appendStrokes(std::string_view strokes, double left, std::vector<std::array<Vec2, 2>> &lines) {
    bool down = false, moved = false;
    Vec2 last;
    const auto lift = [&] {
        if (down && !moved) {
            lines.push_back({last, last}); // a dot
        }
        down = moved = false;
    };
    for (std::size_t k = 0; k < strokes.size();) {
        if (strokes[k] == ' ') {
            lift();
            ++k;
            continue;
        }
        const Vec2 point = latticePoint(strokes[k], strokes[k + 1]) + Vec2{left, 0.0};
        if (down) {
            lines.push_back({last, point});
            moved = true;
        }
        down = true;
        last = point;
        k += 2;
    }
    lift();
}

} // namespace

double strokeTextWidth(std::string_view text) {
    double width = 0.0;
    forCharacters(text, [&](std::string_view strokes) { width += widthOf(strokes) + kGap; });
    return width;
}

std::vector<std::array<Vec2, 2>> strokeText(std::string_view text) {
    std::vector<std::array<Vec2, 2>> lines;
    double left = 0.0;
    forCharacters(text, [&](std::string_view strokes) {
        appendStrokes(strokes, left, lines);
        left += widthOf(strokes) + kGap;
    });
    return lines;
}

} // namespace forefront
