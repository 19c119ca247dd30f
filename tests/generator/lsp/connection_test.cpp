#include "lsp/connection.h"

#include <gtest/gtest.h>

#include <sstream>
#include <thread>
#include <vector>

#include "lsp/messages.h"

namespace mjcourse {
namespace {

using nlohmann::json;

TEST(Connection, AnswersRefusesAndTells) {
  std::stringstream out;
  Connection connection(out);
  connection.answer("a", nullptr);
  connection.refuse(7, Fault::unknown_method, "there is no method juggle");
  connection.notify("textDocument/publishDiagnostics", {{"uri", "file:///x"}});
  EXPECT_EQ(read_message(out), R"({"id":"a","jsonrpc":"2.0","result":null})");
  EXPECT_EQ(read_message(out), R"({"error":{"code":-32601,"message":"there is no method juggle"},)"
                               R"("id":7,"jsonrpc":"2.0"})");
  EXPECT_EQ(read_message(out), R"({"jsonrpc":"2.0","method":"textDocument/publishDiagnostics",)"
                               R"("params":{"uri":"file:///x"}})");
  EXPECT_EQ(read_message(out), std::nullopt);
}

// A lesson's line may hold anything; what no JSON may hold does not end the server.
TEST(Connection, SaysWhatIsNoUtf8AsWellAsItCan) {
  std::stringstream out;
  Connection(out).answer(1, "a\xFFz");
  EXPECT_EQ(read_message(out), "{\"id\":1,\"jsonrpc\":\"2.0\",\"result\":\"a\uFFFDz\"}");
}

TEST(Connection, SaysOneMessageAtATime) {
  std::stringstream out;
  Connection connection(out);
  const std::string text(5000, 'x');
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < 4; ++i) {
      threads.emplace_back([&] {
        for (int j = 0; j < 50; ++j) connection.notify(text, nullptr);
      });
    }
  }
  const json expected{{"jsonrpc", "2.0"}, {"method", text}, {"params", nullptr}};
  int heard = 0;
  while (const auto body = read_message(out)) {
    ASSERT_EQ(*body, expected.dump());
    ++heard;
  }
  EXPECT_EQ(heard, 200);
}

}  // namespace
}  // namespace mjcourse
