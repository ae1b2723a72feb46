# docker build -t stiffaxis .
# docker run --rm -u "$(id -u):$(id -g)" -v "$PWD:/work" stiffaxis run fig4.yaml --out results/fig4
FROM debian:12-slim AS build
ENV DEBIAN_FRONTEND=noninteractive
WORKDIR /build/stiffaxis
COPY debian/control debian/control
RUN apt-get update \
    && apt-get install -y --no-install-recommends build-essential debhelper \
    && apt-get build-dep -y --no-install-recommends ./
COPY . .
RUN dpkg-buildpackage -us -uc -b \
    && mkdir /build/packages \
    && mv ../stiffaxis_*.deb /build/packages/stiffaxis.deb

FROM debian:12-slim
COPY --from=build /build/packages/stiffaxis.deb /tmp/stiffaxis.deb
# the package knows which libraries it needs, and which it recommends
RUN apt-get update \
    && DEBIAN_FRONTEND=noninteractive apt-get install -y /tmp/stiffaxis.deb \
    && rm -rf /tmp/stiffaxis.deb /var/lib/apt/lists/* \
    && useradd --create-home --uid 1000 designer
# fonts are remembered there, whoever it runs as
ENV HOME=/tmp
USER designer
WORKDIR /work
ENTRYPOINT ["stiffaxis"]
CMD ["--help"]
