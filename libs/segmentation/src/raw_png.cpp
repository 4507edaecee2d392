#include "raw_png.h"

#include <png.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace wardslam::segmentation {
namespace {

/// Bytes in memory for libpng, which leaves by exception where there are no more.
class Reader {
 public:
  explicit Reader(const std::vector<char>& bytes) : bytes_(bytes) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, &fail, [](png_structp, png_const_charp) {});
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
    if (info_ == nullptr) throw std::runtime_error("out of memory");
    png_set_read_fn(png_, this, [](png_structp png, png_bytep to, std::size_t size) {
      static_cast<Reader*>(png_get_io_ptr(png))->take(to, size);
    });
  }
  ~Reader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  RawPng read() {
    png_read_info(png_, info_);
    RawPng image;
    image.bits = png_get_bit_depth(png_, info_);
    const int colorType = png_get_color_type(png_, info_);
    const bool isInterlaced = png_get_interlace_type(png_, info_) != PNG_INTERLACE_NONE;
    if (isInterlaced || (colorType != PNG_COLOR_TYPE_GRAY && colorType != PNG_COLOR_TYPE_PALETTE)) return image;
    image.kind = colorType == PNG_COLOR_TYPE_GRAY ? RawPng::Kind::Gray : RawPng::Kind::Palette;
    image.values.create(static_cast<int>(png_get_image_height(png_, info_)),
                        static_cast<int>(png_get_image_width(png_, info_)), image.bits == 16 ? CV_16UC1 : CV_8UC1);
    if (image.bits < 8) png_set_packing(png_);
    if (image.bits == 16) png_set_swap(png_);  // to little endian
    png_read_update_info(png_, info_);
    if (png_get_rowbytes(png_, info_) > image.values.step[0]) throw std::runtime_error("rows are longer than they say");
    for (int y = 0; y < image.values.rows; ++y) png_read_row(png_, image.values.ptr(y), nullptr);
    return image;
  }

 private:
  [[noreturn]] static void fail(png_structp /*png*/, png_const_charp message) { throw std::runtime_error(message); }

  void take(png_bytep to, std::size_t size) {
    if (size > bytes_.size() - used_) png_error(png_, "cut off");
    std::memcpy(to, bytes_.data() + used_, size);
    used_ += size;
  }

  const std::vector<char>& bytes_;
  std::size_t used_ = 0;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

}  // namespace

RawPng readRawPng(const std::vector<char>& bytes) {
  constexpr std::size_t kSignature_bytes = 8;
  const bool isPng = bytes.size() > kSignature_bytes &&
                     png_sig_cmp(reinterpret_cast<png_const_bytep>(bytes.data()), 0, kSignature_bytes) == 0;
  if (!isPng) return {};
  try {
    return Reader(bytes).read();
  } catch (const std::exception&) {
    return {};
  }
}

}  // namespace wardslam::segmentation
