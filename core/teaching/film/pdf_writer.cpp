#include "core/teaching/film/pdf_writer.hpp"

#include "core/engine/base/number_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace forefront {

namespace {

/// A character as a PDF font encodes it.
struct PdfGlyph {
    bool symbol = false; ///< font Symbol, else Helvetica with WinAnsiEncoding
    unsigned char code = '?';
};

PdfGlyph glyphOf(char32_t character) {
    struct Entry {
        char32_t character;
        PdfGlyph glyph;
    };
    constexpr std::array<Entry, 18> kOthers{{{U'α', {true, 'a'}},
                                             {U'β', {true, 'b'}},
                                             {U'γ', {true, 'g'}},
                                             {U'δ', {true, 'd'}},
                                             {U'ρ', {true, 'r'}},
                                             {U'π', {true, 'p'}},
                                             {U'Γ', {true, 'G'}},
                                             {U'Δ', {true, 'D'}},
                                             {U'→', {true, 0xAE}},
                                             {U'∅', {true, 0xC6}},
                                             {U'≤', {true, 0xA3}},
                                             {U'≥', {true, 0xB3}},
                                             {U'−', {true, 0x2D}},
                                             {U'√', {true, 0xD6}},
                                             {U'…', {false, 0x85}},
                                             {U'’', {false, 0x92}},
                                             {U'–', {false, 0x96}},
                                             {U'—', {false, 0x97}}}};
    if ((character >= U' ' && character <= U'~') || (character >= U'\u00a0' && character <= U'\u00ff')) {
        return {false, static_cast<unsigned char>(character)};
    }
    const auto *const found =
        std::find_if(kOthers.begin(), kOthers.end(), [&](const Entry &entry) { return entry.character == character; });
    return found != kOthers.end() ? found->glyph : PdfGlyph();
}

/// Takes the first character from a text in UTF-8.
char32_t takeCharacter(std::string_view &text) {
    const auto first = static_cast<unsigned char>(text.front());
    const std::size_t length = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    char32_t character = length == 1 ? first : first & (0x7FU >> length);
    for (std::size_t k = 1; k < std::min(length, text.size()); ++k) {
        character = character << 6 | (static_cast<unsigned char>(text[k]) & 0x3FU);
    }
    text.remove_prefix(std::min(length, text.size()));
    return character;
}

/// Returns a number rounded to thousandths, as PDF reads it.
std::string pdfNumber(double value) {
    return numberText(std::round(value * 1000.0) / 1000.0, 8);
}
std::string pdfPoint(Vec2 p) {
    return pdfNumber(p.x) + ' ' + pdfNumber(p.y) + ' ';
}

/// Appends drawing operators to the content of a page.
class PdfPage {
  public:
    explicit PdfPage(const FilmScene &scene) {
        constexpr double kPoint = 0.75;                                                        // points per pixel
        content_ = "q 0.75 0 0 -0.75 0 " + pdfNumber(kPoint * scene.height) + " cm 1 J 1 j\n"; // y down, round ends
        fill(Ink::Paper);
        rectangle({0.0, 0.0}, {static_cast<double>(scene.width), static_cast<double>(scene.height)});
        fill(Ink::Face);
        for (const FilmElement &element : scene.elements) {
            for (const Vec2 &corner : element) {
                content_ += pdfPoint(corner) + (&corner == element.begin() ? "m " : "l ");
            }
            content_ += "f\n";
        }
        for (const FilmLine &line : scene.lines) {
            stroke(line.ink, line.width);
            content_ += pdfPoint(line.a) + "m " + pdfPoint(line.b) + "l S\n";
        }
        for (const FilmCircle &each : scene.circles) {
            circle(each);
        }
        if (scene.paperFrom) {
            fill(Ink::Paper);
            rectangle({0.0, *scene.paperFrom}, {static_cast<double>(scene.width), scene.height - *scene.paperFrom});
        }
        for (const FilmText &each : scene.texts) {
            text(each);
        }
        if (scene.progress > 0.0) {
            fill(Ink::Front);
            rectangle({0.0, scene.height - 4.0}, {scene.progress * scene.width, 4.0});
        }
        content_ += "Q\n";
    }
    const std::string &content() const { return content_; }

  private:
    void colour(Ink ink, const char *operation) {
        for (const std::uint8_t part : rgbOf(ink)) {
            content_ += pdfNumber(part / 255.0) + ' ';
        }
        content_ += operation;
    }
    void fill(Ink ink) { colour(ink, "rg\n"); }
    /// Sets the pen, unless it is set already.
    void stroke(Ink ink, double width) {
        if (const auto pen = std::make_pair(ink, width); pen != pen_) {
            pen_ = pen;
            colour(ink, "RG ");
            content_ += pdfNumber(width) + " w\n";
        }
    }
    void rectangle(Vec2 corner, Vec2 size) { content_ += pdfPoint(corner) + pdfPoint(size) + "re f\n"; }
    void circle(const FilmCircle &circle) {
        constexpr double kQuarter = 0.5522847498; // 4/3 (√2 - 1): control points of a quarter of a circle
        stroke(circle.ink, circle.width);
        Vec2 radius{circle.radius, 0.0};
        content_ += pdfPoint(circle.centre + radius) + "m ";
        for (int k = 0; k < 4; ++k) {
            const Vec2 next{-radius.y, radius.x};
            content_ += pdfPoint(circle.centre + radius + kQuarter * next) +
                        pdfPoint(circle.centre + next + kQuarter * radius) + pdfPoint(circle.centre + next) + "c ";
            radius = next;
        }
        content_ += "S\n";
    }
    void text(const FilmText &text) {
        fill(text.ink);
        content_ += "BT 1 0 0 -1 " + pdfPoint(text.at) + "Tm\n";
        std::string_view rest = text.text;
        std::string run;
        bool symbol = false;
        const auto show = [&] {
            if (!run.empty()) {
                content_ += (symbol ? "/F2 " : "/F1 ") + pdfNumber(text.size) + " Tf (" + run + ") Tj\n";
                run.clear();
            }
        };
        while (!rest.empty()) {
            const PdfGlyph glyph = glyphOf(takeCharacter(rest));
            if (glyph.symbol != symbol) {
                show();
                symbol = glyph.symbol;
            }
            appendCode(glyph.code, run);
        }
        show();
        content_ += "ET\n";
    }
    static void appendCode(unsigned char code, std::string &run) {
        if (code == '(' || code == ')' || code == '\\') {
            run += '\\';
        }
        if (code < 0x80) {
            run += static_cast<char>(code);
        } else {
            run += '\\';
            for (const unsigned shift : {6U, 3U, 0U}) {
                run += static_cast<char>('0' + (code >> shift & 7U));
            }
        }
    }

    std::string content_;
    std::pair<Ink, double> pen_{Ink::Paper, -1.0};
};

} // namespace

std::string pdfOf(const FilmScene &scene) {
    const std::string content = PdfPage(scene).content();
    const std::string size = pdfNumber(0.75 * scene.width) + ' ' + pdfNumber(0.75 * scene.height);
    const std::array<std::string, 6> objects = {
        "<< /Type /Catalog /Pages 2 0 R >>",
        "<< /Type /Pages /Kids [3 0 R] /Count 1 >>",
        "<< /Type /Page /Parent 2 0 R /MediaBox [0 0 " + size +
            "] /Contents 4 0 R /Resources << /Font << /F1 5 0 R /F2 6 0 R >> >> >>",
        "<< /Length " + std::to_string(content.size()) + " >>\nstream\n" + content + "endstream",
        "<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding >>",
        "<< /Type /Font /Subtype /Type1 /BaseFont /Symbol >>"};
    std::string file = "%PDF-1.4\n";
    std::string table = "xref\n0 7\n0000000000 65535 f \n";
    for (std::size_t k = 0; k < objects.size(); ++k) {
        const std::string offset = std::to_string(file.size());
        table += std::string(10 - offset.size(), '0') + offset + " 00000 n \n";
        file += std::to_string(k + 1) + " 0 obj\n" + objects[k] + "\nendobj\n";
    }
    const std::string start = std::to_string(file.size());
    return file + table + "trailer\n<< /Size 7 /Root 1 0 R >>\nstartxref\n" + start + "\n%%EOF\n";
}

} // namespace forefront
