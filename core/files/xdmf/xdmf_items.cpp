#include "core/files/xdmf/xdmf_items.hpp"

#include "core/engine/base/letter_case.hpp"
#include "core/files/components/hdf5_component.hpp"

#include <filesystem>
#include <optional>
#include <string_view>

namespace forefront {

namespace {

constexpr std::string_view kXmlBlanks = " \t\r\n";

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(kXmlBlanks);
    return begin == std::string_view::npos ? std::string_view()
                                           : text.substr(begin, text.find_last_not_of(kXmlBlanks) + 1 - begin);
}

/// Reads the numbers in the text of an item and compares their count with its dimensions.
bool readItemText(TextScanner &scanner, const pugi::xml_node &item, XdmfNumbers &numbers) {
    const std::size_t place = offsetOfXml(item);
    std::string_view dimensions = trimmed(item.attribute("Dimensions").value());
    const auto nextWord = [](std::string_view &text) {
        const std::string_view word = text.substr(0, text.find_first_of(kXmlBlanks));
        text = trimmed(text.substr(word.size()));
        return word;
    };
    std::string_view text = trimmed(item.child_value());
    while (!text.empty()) {
        const std::string_view word = nextWord(text);
        const std::optional<double> value = parseReal(word);
        if (!value) {
            return scanner.fail(place, "bad-number", "the data item has " + inQuotes(word) + " in place of a number");
        }
        numbers.values.push_back(*value);
        if (numbers.values.size() % 4096 == 0 && scanner.stopped()) {
            return false;
        }
    }
    std::size_t count = 1;
    while (!dimensions.empty()) {
        const std::string_view word = nextWord(dimensions);
        const std::optional<double> value = parseReal(word);
        constexpr double kMany = 1e15;
        if (!value || !(*value >= 0.0 && *value <= kMany) ||
            *value != static_cast<double>(static_cast<std::uint64_t>(*value))) {
            return scanner.fail(place, "bad-number", "the data item has the dimension " + inQuotes(word));
        }
        numbers.dimensions.push_back(static_cast<std::uint64_t>(*value));
        const auto size = static_cast<std::size_t>(*value);
        if (size != 0 && count > numbers.values.size() / size) {
            count = numbers.values.size() + 1; // too many in any case
            break;
        }
        count *= size;
    }
    return count == numbers.values.size() ||
           scanner.fail(place, "bad-count",
                        "the data item holds " + std::to_string(numbers.values.size()) +
                            " numbers, but its dimensions are " + inQuotes(item.attribute("Dimensions").value()));
}

/// Reads an array of an HDF5 file, named "FILE:/PATH".
bool readItemHdf(TextScanner &scanner, const pugi::xml_node &item, XdmfNumbers &numbers) {
    const SourceText &source = scanner.source();
    const std::size_t place = offsetOfXml(item);
    const std::string name(trimmed(item.child_value()));
    const std::size_t colon = name.rfind(':');
    if (colon == std::string::npos || colon == 0) {
        return scanner.fail(place, "bad-syntax", "expected FILE:/PATH of an array in HDF5, found " + inQuotes(name));
    }
    if (source.path.empty()) {
        return scanner.fail(place, "cannot-read", "the arrays lie in another file, " + inQuotes(name.substr(0, colon)),
                            "read the file from its folder");
    }
    const Result<const Hdf5Functions *> hdf5 = hdf5Component();
    if (!hdf5) {
        const Diagnostic &fault = hdf5.faults().front();
        return scanner.fail(place, fault.code, fault.message, fault.advice);
    }
    const std::filesystem::path file = source.path.parent_path() / name.substr(0, colon);
    std::error_code none;
    if (!std::filesystem::is_regular_file(file, none)) {
        return scanner.fail(place, "cannot-read",
                            "the file with the arrays, " + inQuotes(file.string()) + ", was not found");
    }
    Hdf5Values read;
    std::string message;
    if (!(*hdf5)->read(file.string(), name.substr(colon + 1), source.options.maxBytes / sizeof(double), read,
                       message)) {
        return scanner.fail(place, "cannot-read", file.string() + ": " + message);
    }
    numbers = {std::move(read.dimensions), std::move(read.values)};
    return true;
}

} // namespace

bool readXdmfItem(TextScanner &scanner, const pugi::xml_node &parent, XdmfNumbers &numbers) {
    const pugi::xml_node item = parent.child("DataItem");
    const std::size_t place = offsetOfXml(item ? item : parent);
    if (!item || item.attribute("Reference") ||
        std::string_view(item.attribute("ItemType").as_string("Uniform")) != "Uniform") {
        return scanner.fail(place, "bad-syntax",
                            "expected one data item with numbers, or an array in HDF5, in <" +
                                std::string(parent.name()) + '>');
    }
    const std::string format = upperCase(item.attribute("Format").as_string("XML"));
    numbers = {};
    if (format == "XML") {
        return readItemText(scanner, item, numbers);
    }
    if (format == "HDF") {
        return readItemHdf(scanner, item, numbers);
    }
    return scanner.fail(place, "bad-syntax", "data items in the format " + inQuotes(format) + " cannot be read",
                        "write it with HDF5 or as text");
}

} // namespace forefront
