// JavaScript values as C++ sees them: a thin layer over JavaScriptCore's C API.
//
// Strings are UTF-8 on our side and end at their first NUL. A script's need not be whole: whatever
// comes out of an engine goes through text_of() or json_of(), which see to that. A value lives
// while a JavaScript variable, this stack or a Protected holds it.
// Tested by tests/generator/script/engine_test.cpp.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "script/javascriptcore.h"

namespace mjcourse {

// A string on its way into JavaScriptCore.
class JsString {
 public:
  explicit JsString(const std::string& text)
      : string_(JSStringCreateWithUTF8CString(text.c_str())) {}
  ~JsString() { JSStringRelease(string_); }
  JsString(const JsString&) = delete;
  JsString& operator=(const JsString&) = delete;

  operator JSStringRef() const { return string_; }

 private:
  JSStringRef string_;
};

// Keeps an object from the garbage collector. The context must outlive it.
class Protected {
 public:
  Protected(JSContextRef context, JSObjectRef object);
  ~Protected();
  Protected(Protected&& other) noexcept;
  Protected& operator=(Protected&&) = delete;

  operator JSObjectRef() const { return object_; }

 private:
  JSContextRef context_;
  JSObjectRef object_;  // null when moved from
};

JSValueRef make_text(JSContextRef context, const std::string& text);
JSObjectRef make_empty_array(JSContextRef context);

// What String(value) gives; "" where that throws. Half of a surrogate pair becomes U+FFFD.
std::string text_of(JSContextRef context, JSValueRef value);

// What JSON.stringify() gave, again with U+FFFD for half of a pair. Throws
// nlohmann::json::exception when it is no JSON.
nlohmann::json json_of(std::string text);

// `object[name]`; undefined where that throws.
JSValueRef property(JSContextRef context, JSObjectRef object, const std::string& name);
void set_property(JSContextRef context, JSObjectRef object, const std::string& name,
                  JSValueRef value);

// The object in `value`, null when it is none.
JSObjectRef object_in(JSContextRef context, JSValueRef value);

}  // namespace mjcourse
