#include "tools/printer/serial_port.h"

#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <libserialport.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include "machine/base/contract.h"
#include "tools/printer/line_code.h"

namespace g31::printer {
namespace {

using Opened = Result<std::shared_ptr<SerialPort>, std::string>;

constexpr int kClosed = -1;

/// The device before anything is set: keeps it open, and its settings.
class Device {
 public:
  explicit Device(const std::string& path)
      : fd_(::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC)) {}
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;
  ~Device() {
    if (is_terminal_) {
      ::tcsetattr(fd_, TCSADRAIN, &found_);
    }
    if (fd_ != kClosed) {
      ::close(fd_);
    }
  }

  [[nodiscard]] bool is_open() const { return fd_ != kClosed; }
  [[nodiscard]] int descriptor() const { return fd_; }
  [[nodiscard]] const termios& found() const { return found_; }

  /// Whether it has settings to give back; only then it is a serial line at all.
  bool read_settings() {
    is_terminal_ = ::tcgetattr(fd_, &found_) == 0;
    return is_terminal_;
  }
  [[nodiscard]] bool has_modem_lines() const {
    int lines = 0;
    return ::ioctl(fd_, TIOCMGET, &lines) == 0;
  }

 private:
  int fd_;
  bool is_terminal_ = false;
  termios found_ = {};
};

std::string reason_of(sp_return code) {
  switch (code) {
    case SP_ERR_ARG:
      return "the port does not know it";
    case SP_ERR_MEM:
      return "out of memory";
    case SP_ERR_SUPP:
      return "the port cannot do it";
    case SP_OK:
    case SP_ERR_FAIL:
      return std::strerror(errno);
  }
  return "unknown reason";
}

std::string cannot_open(const std::string& device, int error) {
  const std::string_view advice =
      error == EACCES   ? "; on Debian the user must belong to the group dialout"
      : error == ENOENT ? "; ls /dev/ttyS* /dev/ttyUSB* shows what there is"
      : error == EBUSY  ? "; another program holds it"
                        : "";
  return fmt::format("cannot open {}: {}{}", device, std::strerror(error), advice);
}

sp_parity library_parity(Parity parity) {
  switch (parity) {
    case Parity::None:
      return SP_PARITY_NONE;
    case Parity::Even:
      return SP_PARITY_EVEN;
    case Parity::Odd:
      return SP_PARITY_ODD;
  }
  contract_violated("every parity has its name in the library", __FILE__, __LINE__);
}

/// A port with modem lines, held by libserialport.
class ModemPort final : public SerialPort {
 public:
  explicit ModemPort(std::unique_ptr<Device> device) : device_(std::move(device)) {}
  ~ModemPort() override {
    if (fd_ != kClosed) {
      sp_close(port_);
    }
    sp_free_port(port_);
  }

  sp_return open() {
    // libserialport looks for a link of the port's name below /sys/class/tty.  This name is a link
    // to the device from there as from /dev: so any name of a device may be given to us.
    const auto name = fmt::format("/dev/../../../proc/self/fd/{}", device_->descriptor());
    sp_return code = sp_get_port_by_name(name.c_str(), &port_);
    code = code == SP_OK ? sp_open(port_, SP_MODE_READ_WRITE) : code;
    return code == SP_OK ? sp_get_port_handle(port_, &fd_) : code;
  }

  sp_return set_up(const LineSpec& line) {
    const Frame frame = frame_of(line);
    sp_return code = sp_set_baudrate(port_, line.baud);
    code = code == SP_OK ? sp_set_bits(port_, frame.data_bits) : code;
    code = code == SP_OK ? sp_set_parity(port_, library_parity(frame.parity)) : code;
    code = code == SP_OK ? sp_set_stopbits(port_, frame.stop_bits) : code;
    code = code == SP_OK ? sp_set_rts(port_, SP_RTS_ON) : code;
    code = code == SP_OK ? sp_set_dtr(port_, SP_DTR_ON) : code;
    // DC1 and DC3 are for us: the driver does not know them with a parity bit.
    return code == SP_OK ? sp_set_flowcontrol(port_, SP_FLOWCONTROL_NONE) : code;
  }

  [[nodiscard]] int descriptor() const override { return fd_; }

 private:
  std::unique_ptr<Device> device_;  // goes last: gives the settings back
  sp_port* port_ = nullptr;
  int fd_ = kClosed;
};

/// A terminal without modem lines: no frame, no rate, only bytes.
class PlainTerminal final : public SerialPort {
 public:
  explicit PlainTerminal(std::unique_ptr<Device> device) : device_(std::move(device)) {}

  [[nodiscard]] bool set_up() const {
    termios raw = device_->found();
    ::cfmakeraw(&raw);
    return ::tcsetattr(device_->descriptor(), TCSANOW, &raw) == 0;
  }

  [[nodiscard]] int descriptor() const override { return device_->descriptor(); }

 private:
  std::unique_ptr<Device> device_;
};

Opened open_modem_port(std::unique_ptr<Device> device, const LineSpec& line) {
  const auto port = std::make_shared<ModemPort>(std::move(device));
  if (const sp_return code = port->open(); code != SP_OK) {
    return fmt::format("cannot open {}: {}", line.device, reason_of(code));
  }
  if (const sp_return code = port->set_up(line); code != SP_OK) {
    return fmt::format("{} cannot be set to {} baud, {} data bits, {} stop bits: {}", line.device,
                       line.baud, line.data_bits, line.stop_bits, reason_of(code));
  }
  return std::shared_ptr<SerialPort>(port);
}

}  // namespace

Opened open_serial_port(const LineSpec& line) {
  auto device = std::make_unique<Device>(line.device);
  if (!device->is_open()) {
    return cannot_open(line.device, errno);
  }
  if (!device->read_settings()) {
    return fmt::format("{} is not a serial line: {}", line.device,
                       errno == ENOTTY ? "it is not a terminal" : std::strerror(errno));
  }
  if (device->has_modem_lines()) {
    return open_modem_port(std::move(device), line);
  }
  const auto terminal = std::make_shared<PlainTerminal>(std::move(device));
  if (!terminal->set_up()) {
    return fmt::format("{} cannot be set up: {}", line.device, std::strerror(errno));
  }
  return std::shared_ptr<SerialPort>(terminal);
}

}  // namespace g31::printer
