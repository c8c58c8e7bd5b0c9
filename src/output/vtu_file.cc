// Format: VTK User's Guide (11th edition, 2010), ch. 19.3, "XML file formats": an appended array is the number of its
// blocks, the size of a block, the size of the last block where that is shorter (else 0), the sizes of the compressed
// blocks, and these blocks; all sizes are UInt32 (header_type).
#include "output/vtu_file.h"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <ostream>
#include <stdexcept>

namespace upbead {

namespace {

/// Small enough for sizes of 32 bits and for the memory of a reader.
constexpr std::size_t block_size = std::size_t{1} << 20;
constexpr int window_bits = 15, memory_level = 9;

void append(std::string& bytes, std::uint32_t number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

/// A stream of zlib; for fields it looks for runs of one byte only (Z_RLE).
class Compressor {
 public:
  explicit Compressor(Packing packing) {
    const bool runs = packing == Packing::of_fields;
    if (deflateInit2(&stream_, runs ? Z_BEST_SPEED : Z_DEFAULT_COMPRESSION, Z_DEFLATED, window_bits, memory_level,
                     runs ? Z_RLE : Z_DEFAULT_STRATEGY) != Z_OK)
      throw std::runtime_error("zlib cannot begin");
  }
  Compressor(const Compressor&) = delete;
  Compressor& operator=(const Compressor&) = delete;
  ~Compressor() { deflateEnd(&stream_); }

  /// Appends a block; returns its size.
  std::uint32_t compress(const char* block, std::size_t size, std::string& bytes) {
    deflateReset(&stream_);
    const std::size_t before = bytes.size(), room = deflateBound(&stream_, size);
    bytes.resize(before + room);
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(block));  // zlib's interface has no const
    stream_.avail_in = static_cast<uInt>(size);
    stream_.next_out = reinterpret_cast<Bytef*>(&bytes[before]);
    stream_.avail_out = static_cast<uInt>(room);
    if (deflate(&stream_, Z_FINISH) != Z_STREAM_END) throw std::logic_error("a block larger than zlib's own bound");
    bytes.resize(before + room - stream_.avail_out);
    return static_cast<std::uint32_t>(bytes.size() - before);
  }

 private:
  z_stream stream_{};
};

std::string compressed(const char* data, std::size_t size, Packing packing) {
  const std::size_t n_blocks = (size + block_size - 1) / block_size;
  std::string header, blocks;
  append(header, static_cast<std::uint32_t>(n_blocks));
  append(header, static_cast<std::uint32_t>(block_size));
  append(header, static_cast<std::uint32_t>(size % block_size));
  Compressor compressor(packing);
  for (std::size_t begin = 0; begin < size; begin += block_size)
    append(header, compressor.compress(data + begin, std::min(block_size, size - begin), blocks));
  return header + blocks;
}

template <class Number>
VtuArray array_of(const std::string& name, const char* type, int components, const std::vector<Number>& values,
                  Packing packing) {
  return {name, type, components,
          compressed(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Number), packing)};
}

/// Declares arrays whose data follow each other at the end of the file.
class Declarations {
 public:
  explicit Declarations(std::ostream& out) : out_(out) {}

  void declare(const VtuArray& array) {
    out_ << "<DataArray type=\"" << array.type << "\" Name=\"" << array.name << "\" NumberOfComponents=\""
         << array.components << "\" format=\"appended\" offset=\"" << offset_ << "\"/>\n";
    offset_ += array.bytes.size();
    arrays_.push_back(&array);
  }

  void append() const {
    for (const VtuArray* array : arrays_)
      out_.write(array->bytes.data(), static_cast<std::streamsize>(array->bytes.size()));
  }

 private:
  std::ostream& out_;
  std::size_t offset_ = 0;
  std::vector<const VtuArray*> arrays_;
};

/// Texts as VTK reads them without a compressor: the code of each byte, a zero behind each text.
void declare_texts(const std::string& name, const std::vector<std::string>& texts, std::ostream& out) {
  out << "<FieldData>\n<DataArray type=\"String\" Name=\"" << name << "\" NumberOfTuples=\"" << texts.size()
      << "\" format=\"ascii\">\n";
  for (const std::string& text : texts) {
    for (const char c : text) out << static_cast<int>(static_cast<unsigned char>(c)) << ' ';
    out << "0\n";
  }
  out << "</DataArray>\n</FieldData>\n";
}

}  // namespace

VtuArray vtu_array(const std::string& name, int components, const std::vector<float>& values, Packing packing) {
  return array_of(name, "Float32", components, values, packing);
}

VtuArray vtu_array(const std::string& name, int components, const std::vector<double>& values, Packing packing) {
  return array_of(name, "Float64", components, values, packing);
}

VtuArray vtu_array(const std::string& name, int components, const std::vector<int>& values, Packing packing) {
  return array_of(name, "Int32", components, values, packing);
}

VtuArray vtu_array(const std::string& name, int components, const std::vector<unsigned char>& values, Packing packing) {
  return array_of(name, "UInt8", components, values, packing);
}

void write_vtu(std::ostream& out, const VtuGrid& grid, const std::vector<VtuArray>& data) {
  const std::uint16_t one = 1;
  const bool little_endian = *reinterpret_cast<const unsigned char*>(&one) == 1;
  Declarations declarations(out);
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\""
      << (little_endian ? "LittleEndian" : "BigEndian")
      << "\" header_type=\"UInt32\" compressor=\"vtkZLibDataCompressor\">\n<UnstructuredGrid>\n";
  if (!grid.region_names.empty()) declare_texts("region_names", grid.region_names, out);
  out << "<Piece NumberOfPoints=\"" << grid.n_points << "\" NumberOfCells=\"" << grid.n_cells << "\">\n<Points>\n";
  declarations.declare(grid.points);
  out << "</Points>\n<Cells>\n";
  for (const VtuArray* array : {&grid.connectivity, &grid.offsets, &grid.types}) declarations.declare(*array);
  out << "</Cells>\n";
  if (!grid.regions.name.empty()) {
    out << "<CellData>\n";
    declarations.declare(grid.regions);
    out << "</CellData>\n";
  }
  out << "<PointData>\n";
  for (const VtuArray& array : data) declarations.declare(array);
  out << "</PointData>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
  declarations.append();
  out << "\n</AppendedData>\n</VTKFile>\n";
}

}  // namespace upbead
