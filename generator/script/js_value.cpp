#include "script/js_value.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "base/utf8.h"

namespace mjcourse {

Protected::Protected(JSContextRef context, JSObjectRef object)
    : context_(context), object_(object) {
  JSValueProtect(context_, object_);
}

Protected::Protected(Protected&& other) noexcept
    : context_(other.context_), object_(std::exchange(other.object_, nullptr)) {}

Protected::~Protected() {
  if (object_ != nullptr) JSValueUnprotect(context_, object_);
}

JSValueRef make_text(JSContextRef context, const std::string& text) {
  return JSValueMakeString(context, JsString(text));
}

JSObjectRef make_empty_array(JSContextRef context) {
  return JSObjectMakeArray(context, 0, nullptr, nullptr);
}

std::string text_of(JSContextRef context, JSValueRef value) {
  JSStringRef string = JSValueToStringCopy(context, value, nullptr);
  if (string == nullptr) return "";
  std::string text(JSStringGetMaximumUTF8CStringSize(string), '\0');
  text.resize(std::max<std::size_t>(1, JSStringGetUTF8CString(string, text.data(), text.size())) -
              1);
  const bool plain = text.size() == JSStringGetLength(string) &&
                     std::all_of(text.begin(), text.end(),
                                 [](char c) { return static_cast<unsigned char>(c) < 0x80; });
  if (!plain) {
    // JavaScriptCore ends at half of a character, which a script may have cut off.
    static_assert(sizeof(JSChar) == sizeof(char16_t));
    const auto* units = reinterpret_cast<const char16_t*>(JSStringGetCharactersPtr(string));
    text = utf8_of({units, JSStringGetLength(string)});
  }
  JSStringRelease(string);
  return text;
}

nlohmann::json json_of(std::string text) {
  // JSON.stringify writes such a half as an escape, and no whole character.
  constexpr std::string_view kHalf = "\\ud", kReplacement = "\\ufffd";
  for (std::size_t at = 0; (at = text.find('\\', at)) != text.npos;) {
    const bool half = text.compare(at, kHalf.size(), kHalf) == 0;
    if (half) text.replace(at, kReplacement.size(), kReplacement);
    at += half ? kReplacement.size() : 2;
  }
  return nlohmann::json::parse(text);
}

JSValueRef property(JSContextRef context, JSObjectRef object, const std::string& name) {
  JSValueRef value = JSObjectGetProperty(context, object, JsString(name), nullptr);
  return value == nullptr ? JSValueMakeUndefined(context) : value;
}

void set_property(JSContextRef context, JSObjectRef object, const std::string& name,
                  JSValueRef value) {
  JSObjectSetProperty(context, object, JsString(name), value, kJSPropertyAttributeNone, nullptr);
}

JSObjectRef object_in(JSContextRef context, JSValueRef value) {
  if (!JSValueIsObject(context, value)) return nullptr;
  return JSValueToObject(context, value, nullptr);
}

}  // namespace mjcourse
