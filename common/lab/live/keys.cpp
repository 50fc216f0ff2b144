// The table of keys.
// SPDX-License-Identifier: MIT
#include "lab/live/keys.hpp"

#include <algorithm>

namespace lab {

namespace {

const Key table[] = {
    {'1',
     false,
     false,
     "1",
     "term albedo toggle",
     {"1 ... 9: i termini dell'equazione; 0: tutti accesi", "1 ... 9: the equation's terms; 0: all on"}},
    {'2', false, false, "2", "term cosine toggle", {}},
    {'3', false, false, "3", "term clamp toggle", {}},
    {'4', false, false, "4", "term light_color toggle", {}},
    {'5', false, false, "5", "term attenuation toggle", {}},
    {'6', false, false, "6", "term directional toggle", {}},
    {'7', false, false, "7", "term point toggle", {}},
    {'8', false, false, "8", "term ambient toggle", {}},
    {'9', false, false, "9", "term specular toggle", {}},
    {'0', false, false, "0", "terms all", {}},
    {'V',
     false,
     false,
     "V",
     "view next",
     {"V, Maiusc+V: che cosa mostra l'immagine", "V, Shift+V: what the picture shows"}},
    {'V', true, false, "Shift+V", "view previous", {}},
    {'L',
     false,
     false,
     "L",
     "choose next",
     {"L: sceglie una luce; O: quella da sola", "L: chooses a light; O: that one alone"}},
    {'L', true, false, "Shift+L", "choose previous", {}},
    {'O', false, false, "O", "only chosen", {}},
    {'/',
     false,
     false,
     "/",
     "split next",
     {"/: prima | dopo, con un divisorio", "/: before | after, with a divider"}},
    {'/', true, false, "/", "split next", {}},
    {'7', true, false, "/", "split next", {}},  // where the / of an Italian keyboard is
    {'P',
     false,
     false,
     "P",
     "pin",
     {"P: fissa la sonda nel punto sotto il mouse; I: la sonda segue il mouse",
      "P: pins the probe to the point under the mouse; I: the probe follows the mouse"}},
    {'I', false, false, "I", "follow toggle", {}},
    {'H',
     false,
     false,
     "H",
     "helpers toggle",
     {"H: mostra le luci, da prendere col mouse; A: ne aggiunge una; Canc: la toglie",
      "H: shows the lights, to be grabbed; A: adds one; Del: takes it out"}},
    {'A', false, false, "A", "light add point", {}},
    {keyDelete, false, false, "Del", "light chosen remove", {}},
    {'G',
     false,
     false,
     "G",
     "shading next",
     {"G: per frammento, vertice, faccia; X: lo spazio; N: la matrice delle normali",
      "G: per fragment, vertex, face; X: the space; N: the matrix of normals"}},
    {'X', false, false, "X", "space next", {}},
    {'N', false, false, "N", "normal-matrix next", {}},
    {'B',
     false,
     false,
     "B",
     "specular next",
     {"B: il riflesso; K: l'esponente k; E: chi disegna; C: quanto costa una luce",
      "B: the highlight; K: the exponent k; E: who draws; C: what a light costs"}},
    {'K', false, false, "K", "decay next", {}},
    {'E', false, false, "E", "renderer next", {}},
    {'C', false, false, "C", "cost", {}},
    {keyTab,
     false,
     false,
     "Tab",
     "slider next",
     {"Tab ← →: sceglie e muove un cursore (con Maiusc: di più)",
      "Tab ← →: chooses and moves a slider (with Shift: farther)"}},
    {keyTab, true, false, "Shift+Tab", "slider previous", {}},
    {keyLeft, false, false, "←", "slider down", {}},
    {keyRight, false, false, "→", "slider up", {}},
    {keyLeft, true, false, "Shift+←", "slider down 10", {}},
    {keyRight, true, false, "Shift+→", "slider up 10", {}},
    {' ',
     false,
     false,
     "Space",
     "play toggle",
     {"spazio: avvia o ferma il movimento", "space: starts or stops the movement"}},
    {'R',
     false,
     false,
     "R",
     "reset",
     {"R: come all'inizio; Ctrl+Z, Ctrl+Y: annulla, rifà", "R: as at the start; Ctrl+Z, Ctrl+Y: undo, redo"}},
    {'Z', false, true, "Ctrl+Z", "undo", {}},
    {'Y', false, true, "Ctrl+Y", "redo", {}},
    {'Z', true, true, "Ctrl+Shift+Z", "redo", {}},
    {'S',
     false,
     false,
     "S",
     "save",
     {"S: salva lo stato; F2: immagine e stato", "S: saves the state; F2: picture and state"}},
    {keyF2, false, false, "F2", "shot", {}},
    {'T',
     false,
     false,
     "T",
     "light theme toggle",
     {"T: tema; + -: caratteri; Y: lingua; Q: comandi; F1: questo elenco",
      "T: theme; + -: type size; Y: language; Q: controls; F1: this list"}},
    {'+', false, false, "+", "font size up", {}},
    {'+', true, false, "+", "font size up", {}},
    {'=', false, false, "+", "font size up", {}},
    {'=', true, false, "+", "font size up", {}},  // where the + of an American keyboard is
    {'-', false, false, "-", "font size down", {}},
    {'Y', false, false, "Y", "language next", {}},
    {'Q', false, false, "Q", "panel toggle", {}},
    {keyF1, false, false, "F1", "keys toggle", {}},
    {keyF11,
     false,
     false,
     "F11",
     "fullscreen",
     {"PagSu, PagGiù: lezione prima, dopo; F11: tutto lo schermo; Esc: esce",
      "PgUp, PgDn: lesson before, after; F11: full screen; Esc: leaves"}},
    {keyPageDown, false, false, "PgDn", "next", {}},
    {keyPageUp, false, false, "PgUp", "previous", {}},
    {keyEscape, false, false, "Esc", "quit", {}},
};

}  // namespace

std::span<const Key> keyTable() { return table; }

std::string commandOf(const Event& event) {
    const auto found = std::find_if(std::begin(table), std::end(table), [&event](const Key& key) {
        return key.code == event.key && key.shift == event.modified && key.control == event.control;
    });
    return found == std::end(table) ? std::string() : found->command;
}

std::string keyFor(const std::string& command) {
    const auto found = std::find_if(std::begin(table), std::end(table),
                                    [&command](const Key& key) { return command == key.command; });
    return found == std::end(table) ? std::string() : found->name;
}

}  // namespace lab
