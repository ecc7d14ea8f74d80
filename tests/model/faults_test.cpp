#include "model/faults.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "model/digest.hpp"

namespace umbral::grader {
namespace {

UnitResult fault(const std::string& id, const std::string& cause, Millipoints points)
{
    UnitResult unit;
    unit.id = id;
    unit.verdict = Verdict::grader_fault;
    unit.message = std::string(fault_preface) + cause;
    unit.unscored = points;
    return unit;
}

TEST(Faults, name_each_cause_once_with_who_pays_and_what_helps)
{
    UnitResult fine;
    fine.verdict = Verdict::wrong;
    fine.message = "No space left on device";
    ClassResult result;
    result.submissions = {{"ana",
                           0,
                           0,
                           {fault("a/one", "writing /c/work-x1: No space left on device", 1000), fine,
                            fault("a/two", "the spawner died", 500)}},
                          {"bruno", 0, 0, {fault("a/one", "writing /c/work-x2: No space left on device", 1000)}}};
    result.unwritten = {{"carla", "/out/carla/report.html: cannot write it: No space left on device"}};
    const std::vector<Fault> found = faults(result);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].cause, "writing /c/work-x1: No space left on device");
    EXPECT_NE(found[0].remedy.find("free some space"), std::string::npos);
    EXPECT_NE(found[0].remedy.find("run the same command again"), std::string::npos);
    EXPECT_EQ(found[0].points, 2000);
    ASSERT_EQ(found[0].places.size(), 3U);
    EXPECT_EQ(found[0].places[1].submission, "bruno");
    EXPECT_EQ(found[0].places[1].unit, "a/one");
    EXPECT_EQ(found[0].places[2].unit, "") << "reports, and no unit";
    EXPECT_EQ(found[1].cause, "the spawner died");
    EXPECT_NE(found[1].remedy.find("umbral doctor"), std::string::npos);
    EXPECT_EQ(to_json(result).at("faults").at(1).at("units").at(0).at("unit"), "a/two");
    EXPECT_TRUE(faults({}).empty());
}

TEST(SecretFingerprint, tells_secrets_apart_and_is_none)
{
    // By Python: hashlib.pbkdf2_hmac("sha256", b"secret", b"umbral-secret-fingerprint-1", 200000, 8).hex()
    EXPECT_EQ(secret_fingerprint("secret"), "3d922697223b8584");
    EXPECT_NE(secret_fingerprint("secret"), secret_fingerprint("secreT"));
    EXPECT_EQ(secret_fingerprint("").size(), 16U);
}

}
}
