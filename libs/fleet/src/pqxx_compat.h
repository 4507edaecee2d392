#pragma once

#include <functional>
#include <pqxx/pqxx>
#include <string>
#include <string_view>

/// Everything that differs between libpqxx 6.4 (Debian 12) and 7.10 (Debian 13).
namespace wardslam::fleet {

template <class... Arguments>
pqxx::result execute(pqxx::transaction_base& transaction, const std::string& sql, const Arguments&... arguments) {
#if PQXX_VERSION_MAJOR >= 7
  return transaction.exec(sql, pqxx::params{arguments...});
#else
  return transaction.exec_params(sql, arguments...);
#endif
}

/// As a parameter of type bytea. The bytes must outlive the call.
inline auto bytesParameter(std::string_view bytes) {
#if PQXX_VERSION_MAJOR >= 7
  return pqxx::binary_cast(bytes);
#else
  return pqxx::binarystring(bytes.data(), bytes.size());
#endif
}

/// Of a column of type bytea.
inline std::string bytesOf(const pqxx::field& field) {
#if PQXX_VERSION_MAJOR >= 7
  const auto bytes = field.as<pqxx::bytes>();
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
#else
  return pqxx::binarystring(field).str();
#endif
}

/// While it lives, what is told on the channel is handed over by connection.await_notification().
class Listener
#if PQXX_VERSION_MAJOR < 7
    : private pqxx::notification_receiver
#endif
{
 public:
  using Hear = std::function<void(const std::string& payload)>;

#if PQXX_VERSION_MAJOR >= 7
  Listener(pqxx::connection& connection, const std::string& channel, Hear hear) {
    connection.listen(channel, [hear = std::move(hear)](const pqxx::notification& told) {
      hear(std::string(std::string_view(told.payload)));
    });
  }
#else
  Listener(pqxx::connection& connection, const std::string& channel, Hear hear)
      : notification_receiver(connection, channel), hear_(std::move(hear)) {}

 private:
  void operator()(const std::string& payload, int /*backend*/) override { hear_(payload); }

  Hear hear_;
#endif
};

}  // namespace wardslam::fleet
