"""Hosts in Python, by Debian's grpcio and stubs that protoc wrote: `seaway serve` as others
meet it.

    python_hosts_test.py SEAWAY STUBS REPOSITORY
"""
import math
import os
import signal
import subprocess
import sys
import tempfile
import unittest

SEAWAY, STUBS, REPOSITORY = sys.argv[1:4]
sys.path.insert(0, STUBS)

import grpc  # noqa: E402
import wave_grpc_pb2_grpc  # noqa: E402
import wave_types_pb2 as xdyn  # noqa: E402
from seaway.v1 import water_pb2 as sea  # noqa: E402
from seaway.v1 import water_pb2_grpc  # noqa: E402

SCENE = os.path.join(REPOSITORY, "configs", "scenes", "canaveral.yaml")
HANGS = 60  # s
TOKEN = "a-token-of-many-characters"


class Service:
    """`seaway serve` as a child, until the block ends."""

    def __init__(self, *options):
        self.child = subprocess.Popen([SEAWAY, "serve", SCENE, *options], stderr=subprocess.PIPE,
                                      text=True)
        self.addresses, self.lines = [], []
        wanted = sum(option in ("--grpc", "--xdyn") for option in options)
        while len(self.addresses) < wanted:
            line = self.child.stderr.readline()
            if not line:
                raise RuntimeError("".join(self.lines))
            self.lines.append(line)
            if " serves " in line:
                self.addresses.append(line.split(" at ")[1].split(" serves ")[0])

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.child.poll() is None:
            self.child.kill()
        self.child.communicate()

    def end(self):
        self.child.send_signal(signal.SIGTERM)
        return self.child.wait(HANGS)


def points(count, t=1.0):
    """Places 7 km from the scene's launch, where its wake is not."""
    return sea.SampleRequest(time_s=t, plane=sea.PlanePoints(
        x_m=[5000 + 1.5 * i for i in range(count)], y_m=[5000 - 0.5 * i for i in range(count)]))


def raw(channel, kind, method):
    """A method without stubs: bytes there and back."""
    return getattr(channel, kind)(method, request_serializer=bytes, response_deserializer=bytes)


class Hosts(unittest.TestCase):
    def test_heights_agree_between_unary_stream_and_xdyn(self):
        with Service("--grpc", "0", "--xdyn", "0") as service:
            water = water_pb2_grpc.WaterStub(grpc.insecure_channel(service.addresses[0]))
            request = points(100)
            one = water.Sample(request, timeout=HANGS)
            self.assertEqual(len(one.height_m), 100)
            for answer in water.SampleStream(iter([request] * 3), timeout=HANGS):
                self.assertEqual(list(answer.height_m), list(one.height_m))
            waves = wave_grpc_pb2_grpc.WavesStub(grpc.insecure_channel(service.addresses[1]))
            grid = waves.elevations(xdyn.XYTGrid(x=request.plane.y_m, y=request.plane.x_m, t=1.0),
                                    timeout=HANGS)
            self.assertEqual([-z for z in grid.z], list(one.height_m))
            spectrum = waves.spectrum(xdyn.SpectrumRequest(x=5000, y=5000, t=1.0), timeout=HANGS)
            height = sum(
                math.sqrt(2 * s.Si[0] * s.Dj[0]) * math.sin(
                    s.k[0] * 5000 * (math.cos(s.psi[0]) + math.sin(s.psi[0])) - s.omega[0] +
                    s.phase[0].phase[0]) for s in spectrum.spectrum)
            self.assertAlmostEqual(height, one.height_m[0], delta=one.largest_bound_m + 1e-9)
            self.assertEqual(service.end(), 0)

    def test_health_and_reflection_are_the_standard_ones(self):
        with Service("--grpc", "0") as service:
            channel = grpc.insecure_channel(service.addresses[0])
            check = raw(channel, "unary_unary", "/grpc.health.v1.Health/Check")
            serving = b"\x08\x01"
            self.assertEqual(check(b"", timeout=HANGS), serving)
            name = b"seaway.v1.Water"
            self.assertEqual(check(b"\x0a" + bytes([len(name)]) + name, timeout=HANGS), serving)
            with self.assertRaises(grpc.RpcError) as refused:
                check(b"\x0a\x04none", timeout=HANGS)
            self.assertEqual(refused.exception.code(), grpc.StatusCode.NOT_FOUND)
            reflect = raw(channel, "stream_stream",
                          "/grpc.reflection.v1alpha.ServerReflection/ServerReflectionInfo")
            listed = next(reflect(iter([b"\x3a\x00"]), timeout=HANGS))
            self.assertIn(name, listed)
            symbol = next(reflect(iter([b"\x22" + bytes([len(name)]) + name]), timeout=HANGS))
            self.assertIn(b"SampleRequest", symbol)

    def test_a_token_is_needed_where_one_is_given(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "token")
            with open(file, "w", encoding="utf-8") as out:
                out.write(TOKEN + "\n")
            with Service("--grpc", "0", "--grpc-token-file", file) as service:
                water = water_pb2_grpc.WaterStub(grpc.insecure_channel(service.addresses[0]))
                for metadata in ([], [("authorization", "Bearer " + TOKEN[:-1] + "x")],
                                 [("authorization", TOKEN)]):
                    with self.assertRaises(grpc.RpcError) as refused:
                        water.Sample(points(1), metadata=metadata, timeout=HANGS)
                    self.assertEqual(refused.exception.code(), grpc.StatusCode.UNAUTHENTICATED)
                metadata = [("authorization", "Bearer " + TOKEN)]
                self.assertEqual(
                    len(water.Sample(points(1), metadata=metadata, timeout=HANGS).height_m), 1)

    def test_tls_answers_those_who_trust_its_certificate(self):
        with tempfile.TemporaryDirectory() as folder:
            key, certificate = (os.path.join(folder, name) for name in ("key.pem", "cert.pem"))
            token = os.path.join(folder, "token")
            with open(token, "w", encoding="utf-8") as out:
                out.write(TOKEN)
            subprocess.run(["openssl", "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-keyout",
                            key, "-out", certificate, "-days", "2", "-subj", "/CN=localhost",
                            "-addext", "subjectAltName=DNS:localhost"], check=True,
                           capture_output=True)
            with Service("--grpc", "0.0.0.0:0", "--grpc-tls-cert", certificate, "--grpc-tls-key",
                         key, "--grpc-token-file", token) as service:
                address = "localhost:" + service.addresses[0].rsplit(":", 1)[1]
                with open(certificate, "rb") as file:
                    trusted = grpc.ssl_channel_credentials(file.read())
                both = grpc.composite_channel_credentials(
                    trusted, grpc.access_token_call_credentials(TOKEN))
                water = water_pb2_grpc.WaterStub(grpc.secure_channel(address, both))
                self.assertEqual(len(water.Sample(points(3), timeout=HANGS).height_m), 3)
                for channel in (grpc.insecure_channel(address),
                                grpc.secure_channel(address, grpc.ssl_channel_credentials())):
                    with self.assertRaises(grpc.RpcError) as refused:
                        water_pb2_grpc.WaterStub(channel).Sample(points(1), timeout=HANGS)
                    self.assertEqual(refused.exception.code(), grpc.StatusCode.UNAVAILABLE)

    def test_a_host_that_is_killed_takes_its_hulls_along(self):
        with Service("--grpc", "0") as service:
            water = water_pb2_grpc.WaterStub(grpc.insecure_channel(service.addresses[0]))
            vessel = water.Describe(sea.DescribeRequest(), timeout=HANGS).vessels[0].name
            script = (
                "import sys, time; sys.path.insert(0, sys.argv[1])\n"
                "import grpc; from seaway.v1 import water_pb2 as sea, water_pb2_grpc\n"
                "water = water_pb2_grpc.WaterStub(grpc.insecure_channel(sys.argv[2]))\n"
                "def poses():\n"
                "    yield sea.PosesRequest(time_s=1, hulls=[sea.HullPose(name='x', "
                "vessel=sys.argv[3], latitude_deg=28.878, longitude_deg=-78.467)])\n"
                "    time.sleep(600)\n"
                "stream = water.SubmitPoses(poses()); next(stream); print('placed', flush=True)\n"
                "time.sleep(600)\n")
            host = subprocess.Popen(
                [sys.executable, "-c", script, STUBS, service.addresses[0], vessel],
                stdout=subprocess.PIPE)
            self.assertEqual(host.stdout.readline(), b"placed\n")
            hulls = lambda: water.Describe(sea.DescribeRequest(), timeout=HANGS).hosted_hulls
            self.assertEqual(hulls(), 1)
            host.kill()
            host.communicate()
            while hulls() != 0:  # the test's own limit ends what hangs
                pass

    def test_what_cannot_be_served_ends_with_two_and_a_message(self):
        def refused(message, *options):
            done = subprocess.run([SEAWAY, "serve", SCENE, *options], capture_output=True,
                                  text=True, timeout=HANGS)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(message, done.stderr)
        with Service("--grpc", "0") as service:
            refused("Address already in use", "--grpc", service.addresses[0])
            refused("Address already in use", "--xdyn", service.addresses[0])
        refused("--grpc: '0.0.0.0:0' is reached from other machines; needs --grpc-tls-cert",
                "--grpc", "0.0.0.0:0")
        refused("xdyn knows neither TLS nor tokens", "--xdyn", "0.0.0.0:0")
        refused("one is given without the other", "--grpc", "0", "--grpc-tls-cert", SCENE)
        refused("is no PEM file", "--grpc", "0", "--grpc-tls-cert", SCENE, "--grpc-tls-key", SCENE)
        refused("--grpc-token-file", "--grpc", "0", "--grpc-token-file", "/nowhere")
        refused("--grpc: '70000' is not allowed", "--grpc", "70000")
        refused("--grpc-most-points", "--grpc", "0", "--grpc-most-points", "0")

    def test_the_example_runs(self):
        example = os.path.join(REPOSITORY, "tests", "examples", "grpc_client.py")
        with Service("--grpc", "0") as service:
            done = subprocess.run([sys.executable, example, service.addresses[0]],
                                  env={**os.environ, "PYTHONPATH": STUBS}, capture_output=True,
                                  text=True, timeout=HANGS)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("a picture of", done.stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
