// Signs a certificate with its own key.
#include "secret_files.hpp"

#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/x509.h>
#include <sys/stat.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>

namespace gaitway::api {
namespace {

template <auto kFree>
struct Freeing {
  void operator()(auto* pointer) const { kFree(pointer); }
};
using Key = std::unique_ptr<EVP_PKEY, Freeing<EVP_PKEY_free>>;
using Certificate = std::unique_ptr<X509, Freeing<X509_free>>;
using File = std::unique_ptr<std::FILE, Freeing<std::fclose>>;

File create(const std::filesystem::path& path) {
  File file(std::fopen(path.c_str(), "w"));
  if (!file || chmod(path.c_str(), 0600) != 0) {
    throw std::runtime_error("cannot make " + path.native());
  }
  return file;
}

Key write_key(const std::filesystem::path& path, SecretFiles::KeyKind kind) {
  constexpr std::size_t kCostlyBits = 3072;
  Key key(kind == SecretFiles::KeyKind::elliptic ? EVP_EC_gen("P-256") : EVP_RSA_gen(kCostlyBits));
  if (!key ||
      PEM_write_PrivateKey(create(path).get(), key.get(), nullptr, nullptr, 0, nullptr, nullptr) != 1) {
    throw std::runtime_error("cannot make the key " + path.native());
  }
  return key;
}

void write_certificate(const std::filesystem::path& path, EVP_PKEY& key, SecretFiles::Validity validity,
                       const std::string& host) {
  const Certificate certificate(X509_new());
  X509* const x509 = certificate.get();
  X509_set_version(x509, 2);
  ASN1_INTEGER_set(X509_get_serialNumber(x509), 1);
  X509_gmtime_adj(X509_getm_notBefore(x509), validity.begins_s);
  X509_gmtime_adj(X509_getm_notAfter(x509), validity.ends_s);
  X509_set_pubkey(x509, &key);
  X509_NAME* const name = X509_get_subject_name(x509);
  if (!host.empty()) {
    X509_NAME_add_entry_by_txt(name, "CN", MBSTRING_ASC, reinterpret_cast<const unsigned char*>(host.data()),
                               static_cast<int>(host.size()), -1, 0);
  }
  X509_set_issuer_name(x509, name);
  if (X509_sign(x509, &key, EVP_sha256()) == 0 || PEM_write_X509(create(path).get(), x509) != 1) {
    throw std::runtime_error("cannot make the certificate " + path.native());
  }
}

}  // namespace

SecretFiles::SecretFiles(KeyKind kind, Validity validity, const std::string& name) {
  std::string pattern = (std::filesystem::temp_directory_path() / "gaitway_api_XXXXXX").native();
  if (mkdtemp(pattern.data()) == nullptr) {
    throw std::runtime_error("cannot make " + pattern);
  }
  folder_ = pattern;
  static_cast<void>(write("token", std::string(kToken) + "\n"));
  const Key key_pair = write_key(key(), kind);
  write_certificate(certificate(), *key_pair, validity, name);
  static_cast<void>(write_key(other_key(), KeyKind::elliptic));
}

SecretFiles::~SecretFiles() {
  std::filesystem::remove_all(folder_);
}

std::filesystem::path SecretFiles::write(const std::string& name, std::string_view text) const {
  const auto path = folder_ / name;
  const File file = create(path);
  if (std::fwrite(text.data(), 1, text.size(), file.get()) != text.size()) {
    throw std::runtime_error("cannot write " + path.native());
  }
  return path;
}

}  // namespace gaitway::api
