// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// The one error type of the library, and the two checks that guard invariants.
#pragma once

#include <cassert>
#include <cstdint>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

namespace mortise {

enum class ErrorCode {
  InvalidArgument,  ///< an option or a shape parameter that has no meaning
  NotFinite,        ///< a coordinate is NaN or infinite; ids are vertices
  BadIndex,         ///< a triangle names a vertex that does not exist; ids are faces
  NotClosed,        ///< a solid was asked for and the surface has open edges; ids are vertex pairs
  NotOriented,      ///< neighbouring faces run the same way along an edge; ids are vertex pairs
  InsideOut,        ///< the whole operand is oriented inwards; ids are faces
  OutOfRange,       ///< a result coordinate does not fit a double
  ResultTooLarge,   ///< more contacts than the memory budget allows
  ParseFailed,      ///< a file does not follow its format; ids are one line number or one byte offset
  UnknownFormat,    ///< neither the name nor the content tells the file format
  FileFailed,       ///< a file cannot be opened, read or written
  Cancelled,        ///< the progress callback asked to stop
  OutOfMemory,      ///< an allocation failed: thrown in JavaScript only, C++ gets std::bad_alloc
  InternalError,    ///< a belief of the library did not hold: please report
};

/// The code as users see it in every language: SCREAMING_SNAKE_CASE, "NOT_CLOSED".
[[nodiscard]] std::string_view error_code_name(ErrorCode code);

/// What the numbers in Error::ids are.
enum class IdKind { None, Vertices, Faces, VertexPairs, Line, Byte };

/// "vertices", "faces", "vertexPairs", "line", "byte"; empty for None.
[[nodiscard]] std::string_view id_kind_name(IdKind kind);

/// Thrown at the public door; docs/errors.md says when, and what to do. Indices are those of the operand as the caller gave it.
/// Operands stay as they were, nothing is lost and the next call works; so it is after std::bad_alloc, which C++ gets unchanged.
class Error : public std::exception {
 public:
  Error(ErrorCode error_code, std::string_view stage_name, std::string text)
      : code(error_code), stage(stage_name), message(std::move(text)) {}

  /// The same error, naming places: at most the first 1,000 ids are kept.
  [[nodiscard]] Error with_ids(IdKind kind, std::vector<std::uint32_t> places) &&;
  /// The same error, naming the operand it is about.
  [[nodiscard]] Error in_operand(std::size_t index) &&;

  [[nodiscard]] const char* what() const noexcept override { return message.c_str(); }

  ErrorCode code;
  std::string stage;    ///< stage of the pipeline, "read_obj", "find_contacts", ...
  std::string message;  ///< one sentence a person can act on
  IdKind id_kind = IdKind::None;
  std::vector<std::uint32_t> ids;
  int operand = -1;  ///< -1: not about one operand
};

/// Throws Error{InternalError}; the text names the entity.
[[noreturn]] void fail_check(const char* condition, const char* file, int line, const std::string& entity);

}  // namespace mortise

/// Believed, always on: throws InternalError naming the entity.
#define MORTISE_CHECK(condition, entity) \
  do { \
    if (!(condition)) ::mortise::fail_check(#condition, __FILE__, __LINE__, (entity)); \
  } while (false)

/// Proved, debug builds only.
#define MORTISE_ASSERT(condition) assert(condition)
