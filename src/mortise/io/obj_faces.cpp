// SPDX-FileCopyrightText: the Mortise authors
// SPDX-License-Identifier: MIT
// Faces, groups, objects and materials of an OBJ text, by the callbacks of tinyobjloader.
#include "mortise/io/obj_faces.h"

#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

#include <istream>
#include <streambuf>

#include "mortise/io/polygon_soup.h"
#include "mortise/io/text.h"

namespace mortise {
namespace {

/// Lets a stream read a text in place.
class TextBuffer : public std::streambuf {
 public:
  explicit TextBuffer(std::string_view text) {
    char* const begin = const_cast<char*>(text.data());  // streambuf asks for it; without overflow() nothing is written
    setg(begin, begin, begin + text.size());
  }
};

/// What the callbacks collect.
struct Collector {
  ObjFaces faces;
  LabelTable labels;
  std::string group;
  std::string object;
  std::string material;
  std::uint32_t label = 0;
  bool label_is_current = false;
};

Collector& collector(void* user_data) { return *static_cast<Collector*>(user_data); }

void on_face(void* user_data, tinyobj::index_t* indices, int count) {
  Collector& state = collector(user_data);
  if (!state.label_is_current) {
    state.label = state.labels.label_of(!state.group.empty() ? state.group : !state.object.empty() ? state.object : state.material);
    state.label_is_current = true;
  }
  for (int i = 0; i < count; ++i) {
    state.faces.corners.push_back(indices[i].vertex_index);
    state.faces.textures.push_back(indices[i].texcoord_index);
    state.faces.normals.push_back(indices[i].normal_index);
  }
  state.faces.face_ends.push_back(static_cast<std::uint32_t>(state.faces.corners.size()));
  state.faces.face_labels.push_back(state.label);
}

void on_group(void* user_data, const char** names, int count) {
  Collector& state = collector(user_data);
  state.group.clear();
  for (int i = 0; i < count; ++i) state.group.append(i > 0 ? " " : "").append(names[i]);
  state.label_is_current = false;
}

void on_object(void* user_data, const char* name) {
  Collector& state = collector(user_data);
  state.object = one_line_name(name);
  state.group.clear();
  state.label_is_current = false;
}

void on_material(void* user_data, const char* name, int) {
  Collector& state = collector(user_data);
  state.material = one_line_name(name);
  state.label_is_current = false;
}

}  // namespace

ObjFaces load_obj_faces(std::string_view text) {
  TextBuffer buffer(text);
  std::istream stream(&buffer);
  tinyobj::callback_t callbacks;
  callbacks.index_cb = on_face;
  callbacks.group_cb = on_group;
  callbacks.object_cb = on_object;
  callbacks.usemtl_cb = on_material;
  Collector state;
  tinyobj::LoadObjWithCallback(stream, callbacks, &state, nullptr, nullptr, nullptr);
  if (state.labels.has_names()) {
    state.faces.label_names = state.labels.names();
  } else {
    state.faces.face_labels.clear();
  }
  return std::move(state.faces);
}

}  // namespace mortise
