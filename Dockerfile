# An image with the command `testbed`, in the versions with which bytes are promised (locks/py311.txt).
#
#     docker build -t testbed .
#     docker run --rm -v "$PWD:/work" testbed run left_tail_fail.yaml
FROM python:3.11-slim-bookworm AS wheel
COPY . /source
RUN pip wheel --no-cache-dir --no-deps --wheel-dir /wheels /source

FROM python:3.11-slim-bookworm
COPY --from=wheel /wheels /wheels
COPY locks/py311.txt /wheels/
RUN pip install --no-cache-dir --constraint /wheels/py311.txt pytest \
    "$(echo /wheels/*.whl)[bucket,cluster,export,linear]"
# what numba compiles is kept in the image; another kind of processor compiles it again
RUN testbed run left_tail_fail.yaml --no-plots --out /tmp/first && rm -r /tmp/first
WORKDIR /work
ENTRYPOINT ["testbed"]
