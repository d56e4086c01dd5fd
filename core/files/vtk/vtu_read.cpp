#include "core/files/common/mesh_field.hpp"
#include "core/files/common/planar_mesh.hpp"
#include "core/files/common/vtk_cells.hpp"
#include "core/files/text/base64.hpp"
#include "core/files/vtk/vtk.hpp"

#include <pugixml.hpp>

#include <cmath>
#include <cstring>
#include <limits>

namespace forefront {

namespace {

/// Types of numbers in a VTU file.
enum class NumberType : std::uint8_t {
    Int8,
    UInt8,
    Int16,
    UInt16,
    Int32,
    UInt32,
    Int64,
    UInt64,
    Float32,
    Float64,
    None
};

constexpr std::pair<std::string_view, NumberType> kTypes[] = {
    {"Int8", NumberType::Int8},      {"UInt8", NumberType::UInt8},   {"Int16", NumberType::Int16},
    {"UInt16", NumberType::UInt16},  {"Int32", NumberType::Int32},   {"UInt32", NumberType::UInt32},
    {"Int64", NumberType::Int64},    {"UInt64", NumberType::UInt64}, {"Float32", NumberType::Float32},
    {"Float64", NumberType::Float64}};

template <class Target, class T>
void convert(std::string_view bytes, std::vector<Target> &values) {
    values.resize(bytes.size() / sizeof(T));
    for (std::size_t k = 0; k < values.size(); ++k) {
        T value;
        std::memcpy(&value, bytes.data() + k * sizeof(T), sizeof(T));
        if constexpr (std::is_integral_v<Target> && std::is_floating_point_v<T>) {
            values[k] = std::fabs(value) < T(1e9) ? static_cast<Target>(value) : Target{0};
        } else {
            // An Int8 is a number, not a character. NOLINTNEXTLINE(bugprone-signed-char-misuse)
            values[k] = static_cast<Target>(value);
        }
    }
}

template <class Target>
void convert(NumberType type, std::string_view bytes, std::vector<Target> &values) {
    switch (type) {
    case NumberType::Int8:
        return convert<Target, std::int8_t>(bytes, values);
    case NumberType::UInt8:
        return convert<Target, std::uint8_t>(bytes, values);
    case NumberType::Int16:
        return convert<Target, std::int16_t>(bytes, values);
    case NumberType::UInt16:
        return convert<Target, std::uint16_t>(bytes, values);
    case NumberType::Int32:
        return convert<Target, std::int32_t>(bytes, values);
    case NumberType::UInt32:
        return convert<Target, std::uint32_t>(bytes, values);
    case NumberType::Int64:
        return convert<Target, std::int64_t>(bytes, values);
    case NumberType::UInt64:
        return convert<Target, std::uint64_t>(bytes, values);
    case NumberType::Float32:
        return convert<Target, float>(bytes, values);
    default:
        return convert<Target, double>(bytes, values);
    }
}

/// Reads an unstructured grid of one piece; arrays as ASCII, base64 or appended (raw or base64), not compressed.
class VtuReader {
  public:
    /// Values of points and cells are read only on request, since they may have types that cannot be read.
    VtuReader(const SourceText &source, bool wantsValues)
        : scanner_(source), text_(source.text), wantsValues_(wantsValues) {}

    Result<Mesh> read() {
        Mesh mesh;
        if (!parse() || !grid() || !meshOfVtk(grid_, scanner_, mesh)) {
            return scanner_.faults();
        }
        return mesh;
    }

    MeshFields takeFields(Mesh mesh) { return fieldsOfVtk(std::move(grid_), std::move(mesh), scanner_.source()); }

  private:
    static std::size_t offsetOf(const pugi::xml_node &node) {
        return static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0));
    }

    /// Parses the XML, which ends where raw data begin; open elements are closed.
    bool parse() {
        const std::size_t appended = text_.find("<AppendedData");
        const std::string head =
            appended == std::string_view::npos ? std::string() : std::string(text_.substr(0, appended)) + "</VTKFile>";
        const std::string_view xml = head.empty() ? text_ : head;
        const pugi::xml_parse_result parsed = xml_.load_buffer(xml.data(), xml.size());
        if (!parsed) {
            return scanner_.fail(static_cast<std::size_t>(std::max<std::ptrdiff_t>(parsed.offset, 0)), "xml-syntax",
                                 std::string("the XML is malformed: ") + parsed.description());
        }
        const pugi::xml_node root = xml_.child("VTKFile");
        root_ = root;
        if (std::string_view(root.attribute("type").value()) != "UnstructuredGrid") {
            return scanner_.fail(offsetOf(root), "bad-syntax", "the file is not a VTKFile of type UnstructuredGrid");
        }
        if (std::string_view(root.attribute("byte_order").as_string("LittleEndian")) != "LittleEndian") {
            return scanner_.fail(offsetOf(root), "byte-order", "only little-endian files can be read");
        }
        headerBytes_ = std::string_view(root.attribute("header_type").value()) == "UInt64" ? 8 : 4;
        if (appended == std::string_view::npos) {
            return true;
        }
        const std::size_t open = text_.find('>', appended);
        const std::size_t begin = open == std::string_view::npos ? open : text_.find('_', open);
        const std::size_t end = text_.rfind("</AppendedData>");
        if (begin == std::string_view::npos || end == std::string_view::npos || end < begin) {
            return scanner_.fail(appended, "bad-syntax", "the appended data are incomplete");
        }
        appendedRaw_ = text_.substr(appended, open - appended).find("\"raw\"") != std::string_view::npos;
        appended_ = text_.substr(begin + 1, end - begin - 1);
        return true;
    }

    bool grid() {
        const pugi::xml_node grid = root_.child("UnstructuredGrid");
        const pugi::xml_node piece = grid.child("Piece");
        if (!piece || piece.next_sibling("Piece")) {
            return scanner_.fail(offsetOf(grid), "bad-syntax", "the file must hold exactly one Piece");
        }
        grid_.offset = offsetOf(piece.child("Cells"));
        if (!points(piece.child("Points").child("DataArray"), offsetOf(piece)) ||
            !agrees(piece, "NumberOfPoints", grid_.nodes.size(), "points")) {
            return false;
        }
        for (const pugi::xml_node node : piece.child("Cells").children("DataArray")) {
            const std::string_view name = node.attribute("Name").value();
            std::vector<std::int64_t> *target = name == "connectivity" ? &grid_.connectivity
                                                : name == "offsets"    ? &grid_.ends
                                                : name == "types"      ? &grid_.types
                                                                       : nullptr;
            if (target != nullptr && !numbers(node, *target)) {
                return false;
            }
        }
        return agrees(piece, "NumberOfCells", grid_.types.size(), "cells") &&
               arrays(piece.child("CellData"), grid_.cellArrays) && arrays(grid.child("FieldData"), grid_.fields) &&
               (!wantsValues_ || (realArrays(piece.child("PointData"), grid_.pointArrays) &&
                                  realArrays(piece.child("CellData"), grid_.cellReals)));
    }

    /// Refuses a piece that holds another number of points or cells than its attribute announces.
    bool agrees(const pugi::xml_node &piece, const char *attribute, std::size_t found, const char *what) {
        const pugi::xml_attribute given = piece.attribute(attribute);
        return !given || given.as_ullong() == found ||
               scanner_.fail(offsetOf(piece), "bad-count",
                             std::string(attribute) + " is " + inQuotes(given.value()) + ", but the piece holds " +
                                 std::to_string(found) + ' ' + what,
                             "the file may have been cut short");
    }

    /// Reads arrays of numbers with one component; notes the others.
    bool realArrays(const pugi::xml_node &parent, std::map<std::string, std::vector<double>> &target) {
        for (const pugi::xml_node node : parent.children("DataArray")) {
            const std::string name = node.attribute("Name").value();
            const unsigned components = node.attribute("NumberOfComponents").as_uint(1);
            if (typeOf(node) == NumberType::None) {
                scanner_.source().note("array-type", "the array " + inQuotes(name) + " is ignored: it holds no numbers",
                                       offsetOf(node));
            } else if (components != 1) {
                noteComponents(scanner_.source(), name, components, offsetOf(node));
            } else if (!numbers(node, target[name])) {
                return false;
            }
        }
        return true;
    }

    template <class Target>
    bool arrays(const pugi::xml_node &parent, std::map<std::string, std::vector<Target>> &target) {
        for (const pugi::xml_node node : parent.children("DataArray")) {
            if (typeOf(node) == NumberType::None) { // strings, for example
                if (std::string_view(parent.name()) == "FieldData") {
                    scanner_.source().note("field-data",
                                           "the field data " + inQuotes(node.attribute("Name").value()) + " is ignored",
                                           offsetOf(node));
                }
                continue;
            }
            if (!numbers(node, target[node.attribute("Name").value()])) {
                return false;
            }
        }
        return true;
    }

    bool points(const pugi::xml_node &node, std::size_t place) {
        std::vector<double> values;
        if (!node) {
            return scanner_.fail(place, "bad-syntax", "the piece has no points");
        }
        if (!numbers(node, values)) {
            return false;
        }
        if (values.size() % 3 != 0) {
            return scanner_.fail(offsetOf(node), "bad-count", "the points are not triples of coordinates");
        }
        Box2 box;
        double minimum = std::numeric_limits<double>::infinity(), maximum = -minimum;
        for (std::size_t k = 0; k < values.size(); k += 3) {
            const Vec2 p{values[k], values[k + 1]};
            if (!isFinite(p) || !std::isfinite(values[k + 2])) {
                return scanner_.fail(offsetOf(node), "non-finite",
                                     "the coordinates of node " + std::to_string(k / 3) + " must be finite");
            }
            box.add(p);
            minimum = std::min(minimum, values[k + 2]);
            maximum = std::max(maximum, values[k + 2]);
            grid_.nodes.push_back(p);
        }
        constexpr double kFlat = 1e-9;
        return !(maximum - minimum > kFlat * box.diagonal()) ||
               scanner_.fail(offsetOf(node), "not-planar", "the nodes do not lie in one plane z = constant");
    }

    static NumberType typeOf(const pugi::xml_node &node) {
        for (const auto &[name, type] : kTypes) {
            if (name == node.attribute("type").value()) {
                return type;
            }
        }
        return NumberType::None;
    }

    static std::size_t sizeOf(NumberType type) {
        constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8, 1};
        return kSizes[static_cast<std::size_t>(type)];
    }

    /// Reports progress up to a part of the text; returns false once cancelled.
    bool proceedTo(std::string_view part) {
        return part.empty() || scanner_.proceed(static_cast<std::size_t>(part.data() - text_.data()));
    }

    template <class Target>
    bool numbers(const pugi::xml_node &node, std::vector<Target> &values) {
        const std::string_view format = node.attribute("format").as_string("ascii");
        const NumberType type = typeOf(node);
        const std::size_t place = offsetOf(node);
        values.clear();
        if (type == NumberType::None) {
            return scanner_.fail(place, "bad-field", "unknown array type");
        }
        if (format == "ascii") {
            return ascii(node, values);
        }
        if (root_.attribute("compressor")) {
            return scanner_.fail(place, "compressed", "compressed arrays cannot be read", "save the file uncompressed");
        }
        std::string decoded;
        std::string_view bytes;
        if (format == "appended" && appendedRaw_) {
            const std::uint64_t offset = node.attribute("offset").as_ullong(appended_.size());
            bytes = appended_.substr(static_cast<std::size_t>(std::min<std::uint64_t>(offset, appended_.size())));
            if (!proceedTo(bytes)) {
                return false;
            }
        } else {
            std::string_view encoded;
            if (format == "appended") {
                const std::uint64_t offset = node.attribute("offset").as_ullong(appended_.size());
                encoded = appended_.substr(static_cast<std::size_t>(std::min<std::uint64_t>(offset, appended_.size())));
                encoded = block(encoded);
            } else {
                encoded = content(node);
            }
            if (!proceedTo(encoded)) {
                return false;
            }
            auto result = fromBase64(encoded);
            if (!result) {
                return scanner_.fail(place, "bad-base64", "the array is not base64");
            }
            decoded = std::move(*result);
            bytes = decoded;
        }
        std::uint64_t length = 0;
        if (bytes.size() < headerBytes_) {
            return scanner_.fail(place, "bad-count", "the array is truncated");
        }
        std::memcpy(&length, bytes.data(), headerBytes_);
        if (length > bytes.size() - headerBytes_ || length % sizeOf(type) != 0) {
            return scanner_.fail(place, "bad-count",
                                 "the array should have " + std::to_string(length) + " bytes, but " +
                                     std::to_string(bytes.size() - headerBytes_) + " follow");
        }
        convert(type, bytes.substr(headerBytes_, static_cast<std::size_t>(length)), values);
        return true;
    }

    /// Returns the base64 text of one appended array, which begins with its length.
    std::string_view block(std::string_view text) const {
        const std::size_t headerDigits = headerBytes_ == 8 ? 12 : 8;
        const auto decoded = fromBase64(text.substr(0, headerDigits));
        std::uint64_t length = 0;
        if (!decoded || decoded->size() < headerBytes_) {
            return {};
        }
        std::memcpy(&length, decoded->data(), headerBytes_);
        const std::uint64_t total = length > text.size() ? text.size() : (length + headerBytes_ + 2) / 3 * 4;
        return text.substr(0, static_cast<std::size_t>(std::min<std::uint64_t>(total, text.size())));
    }

    /// Returns the text between the tags of an array, unchanged.
    std::string_view content(const pugi::xml_node &node) const {
        const std::size_t begin = text_.find('>', offsetOf(node));
        if (begin == std::string_view::npos || text_[begin - 1] == '/') {
            return {};
        }
        const std::size_t end = std::min(text_.find('<', begin), text_.size());
        return text_.substr(begin + 1, end - begin - 1);
    }

    template <class Target>
    bool ascii(const pugi::xml_node &node, std::vector<Target> &values) {
        const std::string_view text = content(node);
        const auto begin = text.empty() ? offsetOf(node) : static_cast<std::size_t>(text.data() - text_.data());
        TextScanner numbers = scanner_.part(begin, begin + text.size());
        const Expect expect{"an array"};
        while (!numbers.atEnd()) {
            Target value{};
            double real = 0.0;
            if constexpr (std::is_integral_v<Target>) {
                const NumberType type = typeOf(node);
                if (type == NumberType::Float32 || type == NumberType::Float64) {
                    if (!numbers.real(real, expect)) {
                        return scanner_.fail(numbers);
                    }
                    value = std::fabs(real) < 1e9 ? static_cast<Target>(real) : Target{0};
                } else if (!numbers.integer(value, std::numeric_limits<std::int64_t>::min(),
                                            std::numeric_limits<std::int64_t>::max(), expect)) {
                    return scanner_.fail(numbers);
                }
            } else {
                if (!numbers.real(real, expect)) {
                    return scanner_.fail(numbers);
                }
                value = real;
            }
            values.push_back(value);
        }
        return true;
    }

    TextScanner scanner_;
    std::string_view text_;
    bool wantsValues_;
    pugi::xml_document xml_;
    pugi::xml_node root_;
    std::string_view appended_;
    bool appendedRaw_ = false;
    std::size_t headerBytes_ = 4;
    VtkGrid grid_;
};

} // namespace

bool looksLikeVtu(std::string_view head) {
    return head.find("<VTKFile") != std::string_view::npos;
}

Result<Mesh> readVtu(const SourceText &source) {
    return VtuReader(source, false).read();
}

Result<MeshFields> readVtuFields(const SourceText &source) {
    VtuReader reader(source, true);
    Result<Mesh> mesh = reader.read();
    if (!mesh) {
        return mesh.faults();
    }
    return reader.takeFields(std::move(*mesh));
}

} // namespace forefront
