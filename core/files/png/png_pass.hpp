#pragma once

#include "core/files/png/png_decoder.hpp"

#include <cstddef>
#include <png.h>

namespace forefront {

/// The pixels of one pass over a picture: every `stepX`-th column and every `stepY`-th row.
struct PngPass {
    std::size_t columns = 0, rows = 0, x = 0, y = 0, stepX = 1, stepY = 1;

    PngPass(const PngDecoder &decoder, int pass) : columns(decoder.columns()), rows(decoder.rows()) {
        if (decoder.passes() > 1) {
            x = PNG_PASS_START_COL(pass);
            y = PNG_PASS_START_ROW(pass);
            stepX = PNG_PASS_COL_OFFSET(pass);
            stepY = PNG_PASS_ROW_OFFSET(pass);
            columns = PNG_PASS_COLS(columns, pass);
            rows = columns == 0 ? 0 : PNG_PASS_ROWS(rows, pass);
        }
    }
};

} // namespace forefront
