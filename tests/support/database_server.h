#pragma once

#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "support/temporary_folder.h"

namespace wardslam::test {

/// A PostgreSQL server of the tests' own, on a Unix socket in a temporary folder; ends with this object. As root it
/// runs as the user `postgres`, for it refuses to run as root.
class DatabaseServer {
 public:
  DatabaseServer() {
    if (geteuid() == 0) {
      const passwd* user = getpwnam("postgres");
      if (user == nullptr || chown(folder_.path().c_str(), user->pw_uid, user->pw_gid) != 0)
        throw std::runtime_error("there is no user postgres");
    }
    run(bin() + "/initdb --no-sync --auth=trust --username=postgres --encoding=UTF8 --locale=C -D '" + data() + "'");
    start();
  }
  ~DatabaseServer() { tryTo(bin() + "/pg_ctl stop -w -m immediate -D '" + data() + "'"); }
  DatabaseServer(const DatabaseServer&) = delete;
  DatabaseServer& operator=(const DatabaseServer&) = delete;

  /// Why there can be none here; empty where there can.
  [[nodiscard]] static std::string whyNot() {
    if (bin().empty()) return "no PostgreSQL server is installed (Debian: postgresql, postgresql-postgis)";
    if (geteuid() == 0 && getpwnam("postgres") == nullptr) return "as root, a user postgres is needed";
    return hasPostgis() ? "" : "PostgreSQL has no PostGIS (Debian: postgresql-postgis)";
  }

  void start() const {
    run(bin() + "/pg_ctl start -w -t 60 -D '" + data() + "' -l '" + (folder_.path() / "log").string() +
        "' -o \"-c listen_addresses='' -c fsync=off -c shared_buffers=64MB -k '" + folder_.path().string() + "'\"");
  }
  /// All its processes at once, with SIGKILL.
  void kill() const {
    const pid_t server = std::stoi(readText(folder_.path() / "data/postmaster.pid"));
    ::kill(server, SIGSTOP);  // once it has stopped, it has no more children
    while (statusOf(std::to_string(server)).substr(0, 1) != "T")
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::vector<pid_t> processes = childrenOf(server);
    processes.push_back(server);
    for (const pid_t process : processes) ::kill(process, SIGKILL);
    for (const pid_t process : processes) {
      while (isAlive(process)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    // By these the next start takes a process that nobody has waited for yet for a server that is running.
    std::filesystem::remove(folder_.path() / "data/postmaster.pid");
    std::filesystem::remove(folder_.path() / ".s.PGSQL.5432.lock");
  }

  [[nodiscard]] std::string url(const std::string& database, const std::string& user = "postgres") const {
    return "postgresql:///" + database + "?host=" + folder_.path().string() + "&user=" + user;
  }

  /// A database of this name with what the other one has; its URL.
  std::string make(const std::string& database, const std::string& like = "template1") const {
    sql("postgres", "CREATE DATABASE " + database + " TEMPLATE " + like);
    return url(database);
  }

  /// What psql prints, rows as lines, columns parted by '|'.
  std::string sql(const std::string& database, const std::string& statement) const {
    const auto out = folder_.write("answer", "");
    const auto in = folder_.write("statement", statement);
    run(bin() + "/psql -X -q -A -t -v ON_ERROR_STOP=1 '" + url(database) + "' < '" + in.string() + "' > '" +
            out.string() + "'",
        "");
    std::string text = readText(out);
    if (!text.empty()) text.pop_back();
    return text;
  }

 private:
  static std::string bin() {
    std::vector<std::string> found;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator("/usr/lib/postgresql", error)) {
      if (std::filesystem::exists(entry.path() / "bin/initdb")) found.push_back((entry.path() / "bin").string());
    }
    std::sort(found.begin(), found.end());
    return found.empty() ? std::string() : found.back();
  }
  static bool hasPostgis() {
    const auto release = std::filesystem::path(bin()).parent_path().filename();
    return std::filesystem::exists("/usr/share/postgresql" / release / "extension/postgis.control");
  }
  /// "S 123 ...": state and parent of a process; empty where there is none.
  static std::string statusOf(const std::string& process) {
    const std::string status = readText("/proc/" + process + "/stat");  // number (name) state parent ...
    const auto name = status.rfind(") ");
    return name == std::string::npos ? std::string() : status.substr(name + 2);
  }
  static bool isAlive(pid_t process) {
    const std::string status = statusOf(std::to_string(process));
    return !status.empty() && status[0] != 'Z';
  }
  static std::vector<pid_t> childrenOf(pid_t parent) {
    std::vector<pid_t> children;
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
      const std::string process = entry.path().filename();
      if (process.find_first_not_of("0123456789") != std::string::npos) continue;
      const std::string status = statusOf(process);
      if (!status.empty() && std::stoi(status.substr(2)) == parent) children.push_back(std::stoi(process));
    }
    return children;
  }
  [[nodiscard]] std::string data() const { return (folder_.path() / "data").string(); }

  static std::string asUser() {
    return geteuid() == 0 ? "setpriv --reuid=postgres --regid=postgres --clear-groups " : "";
  }
  bool tryTo(const std::string& command) const {
    return std::system(("cd / && " + asUser() + command + " >/dev/null 2>&1").c_str()) == 0;
  }
  void run(const std::string& command) const {
    if (!tryTo(command)) throw std::runtime_error("failed: " + command + "\n" + readText(folder_.path() / "log"));
  }
  static void run(const std::string& command, const std::string& user) {
    if (std::system((user + command).c_str()) != 0) throw std::runtime_error("failed: " + command);
  }

  TemporaryFolder folder_;
};

}  // namespace wardslam::test
