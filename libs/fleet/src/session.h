#pragma once

#include <string>
#include <utility>

#include "pqxx_compat.h"
#include "wardslam/fleet/database.h"

/// Connections and transactions, and what goes wrong with them as sentences.
namespace wardslam::fleet {

/// Of LISTEN; what is told there is the number of a push.
constexpr const char* kPushChannel = "wardslam_push";

/// Throws CannotConnect.
[[nodiscard]] pqxx::connection connectTo(const std::string& url);

/// Tables are named without their schema from here on. Throws core::InputError where it is not the one of this program.
void enterSchema(pqxx::transaction_base& transaction, const std::string& url);

/// What is being handled, as core::InputError or ConnectionLost with one sentence.
[[noreturn]] void rethrowAsSentence(const std::string& url);

template <class Work>
auto guarded(const std::string& url, const Work& work) {
  try {
    return work();
  } catch (const pqxx::failure&) {
    rethrowAsSentence(url);
  }
}

enum class Isolation {
  Committed,  ///< Sees what others have committed meanwhile.
  OneMoment,  ///< Reads all as it was at the beginning.
};

/// `work(transaction)`, all of it or nothing.
template <class Work>
auto inTransaction(const std::string& url, Isolation isolation, const Work& work) {
  auto connection = connectTo(url);
  return guarded(url, [&] {
    pqxx::work transaction(connection);
    if (isolation == Isolation::OneMoment)
      transaction.exec("SET TRANSACTION ISOLATION LEVEL REPEATABLE READ READ ONLY");
    enterSchema(transaction, url);
    auto result = work(transaction);
    transaction.commit();
    return result;
  });
}

}  // namespace wardslam::fleet
