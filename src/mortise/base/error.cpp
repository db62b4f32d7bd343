// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The one error type of the library.
#include "mortise/base/error.h"

namespace mortise {

std::string_view error_code_name(ErrorCode code) {
  switch (code) {
    case ErrorCode::InvalidArgument:
      return "INVALID_ARGUMENT";
    case ErrorCode::NotFinite:
      return "NOT_FINITE";
    case ErrorCode::BadIndex:
      return "BAD_INDEX";
    case ErrorCode::NotClosed:
      return "NOT_CLOSED";
    case ErrorCode::NotOriented:
      return "NOT_ORIENTED";
    case ErrorCode::InsideOut:
      return "INSIDE_OUT";
    case ErrorCode::OutOfRange:
      return "OUT_OF_RANGE";
    case ErrorCode::ResultTooLarge:
      return "RESULT_TOO_LARGE";
    case ErrorCode::ParseFailed:
      return "PARSE_FAILED";
    case ErrorCode::UnknownFormat:
      return "UNKNOWN_FORMAT";
    case ErrorCode::FileFailed:
      return "FILE_FAILED";
    case ErrorCode::Cancelled:
      return "CANCELLED";
    case ErrorCode::OutOfMemory:
      return "OUT_OF_MEMORY";
    case ErrorCode::InternalError:
      return "INTERNAL_ERROR";
  }
  return "INTERNAL_ERROR";
}

std::string_view id_kind_name(IdKind kind) {
  switch (kind) {
    case IdKind::None:
      return "";
    case IdKind::Vertices:
      return "vertices";
    case IdKind::Faces:
      return "faces";
    case IdKind::VertexPairs:
      return "vertexPairs";
    case IdKind::Line:
      return "line";
    case IdKind::Byte:
      return "byte";
  }
  return "";
}

Error Error::with_ids(IdKind kind, std::vector<std::uint32_t> places) && {
  constexpr std::size_t most_ids = 1000;
  if (places.size() > most_ids) places.resize(most_ids);
  id_kind = kind;
  ids = std::move(places);
  return std::move(*this);
}

Error Error::in_operand(std::size_t index) && {
  operand = static_cast<int>(index);
  return std::move(*this);
}

void fail_check(const char* condition, const char* file, int line, const std::string& entity) {
  const std::string_view path(file);
  const std::string_view name = path.substr(path.find_last_of('/') + 1);
  throw Error(ErrorCode::InternalError, name,
              std::string(condition) + " does not hold for " + entity + " (" + std::string(name) + ":" + std::to_string(line) + ")");
}

}  // namespace mortise
